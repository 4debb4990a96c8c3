#pragma once

#include <array>
#include <span>
#include <vector>

#include "stimuli/alignment/cepstra.hpp"
#include "stimuli/alignment/model_file.hpp"

namespace bimodal {

/// The Gaussian densities of one phone, of which all its states in all contexts are mixtures.
class GaussianCodebook {
 public:
  static constexpr std::size_t kStreams = 3;      ///< cepstra, their slopes, the slopes' slopes
  static constexpr std::size_t kDensities = 128;  ///< in a stream
  static constexpr std::size_t kDimensions = 13;  ///< of a stream

  /// Densities at one frame, each stream's relative to its largest, in order of the streams.
  struct Densities {
    std::array<float, kStreams * kDensities> relative{};
    float log_largest = 0.0F;  ///< product of the largest ones, natural logarithm
  };

  GaussianCodebook() = default;

  /// The tables must have the above shape, and more than `index` codebooks.
  GaussianCodebook(const GaussianTable& means, const GaussianTable& variances, std::size_t index);

  [[nodiscard]] Densities at(const Cepstra& frame) const;

 private:
  std::vector<float> means_;       ///< [stream][dimension][density]
  std::vector<float> precisions_;  ///< half the reciprocal variance, likewise
  std::vector<float> constants_;   ///< [stream][density]: log density at the mean
};

/// Log likelihood of a mixture with one weight a stream and density; the streams are independent.
[[nodiscard]] float log_mixture(const GaussianCodebook::Densities& densities,
                                std::span<const float> weights);

}  // namespace bimodal
