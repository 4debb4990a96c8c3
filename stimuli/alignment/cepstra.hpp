#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "stimuli/base/quantity.hpp"

namespace bimodal {

/// How a frame sounds: 13 mel cepstra less their mean over the recording, then their slopes over
/// 4 frames, then the slopes' differences over 2 (Sphinx's "1s_c_d_dd").
using Cepstra = std::array<float, 39>;

/// Sound to cepstra, by SphinxBase's front end with a model's own parameters.
class CepstraMaker {
 public:
  static constexpr Hertz kRate{16'000};
  static constexpr Duration kFrame = std::chrono::milliseconds{10};       ///< from frame to frame
  static constexpr Duration kWindow = std::chrono::microseconds{25'625};  ///< heard by a frame

  /// `parameters` is a model's feat.params. Throws Error if it cannot be used.
  explicit CepstraMaker(const std::filesystem::path& parameters);
  ~CepstraMaker();
  CepstraMaker(CepstraMaker&&) noexcept;
  CepstraMaker& operator=(CepstraMaker&&) noexcept;
  CepstraMaker(const CepstraMaker&) = delete;
  CepstraMaker& operator=(const CepstraMaker&) = delete;

  /// One entry a frame; frame n hears the window that begins at n * kFrame. Samples are at kRate.
  [[nodiscard]] std::vector<Cepstra> make(std::span<const std::int16_t> samples);

 private:
  struct FrontEnd;
  std::unique_ptr<FrontEnd> front_end_;
};

}  // namespace bimodal
