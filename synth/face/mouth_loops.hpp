#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace bimodal::synth {

/// The loops of the skin cage round the mouth. Ring 3 is the white roll, 4 the vermilion border, 5
/// the fullest vermilion, 6 to 8 the strip where the lips touch, 9 the inside. Column 0 is the
/// upper midline, 8 the corner, 16 the lower midline; upper column k faces lower column 16 - k.
class MouthLoops {
 public:
  enum class Side : std::uint8_t { Left, Right };  ///< the subject's

  static constexpr int kFirstRing = 1;
  static constexpr int kLastRing = 9;
  static constexpr int kCorner = 8;
  static constexpr int kColumns = 17;

  /// One row per vertex of the skin cage; `x` tells the side. Throws Error if a vertex is missing.
  MouthLoops(std::span<const int> ring, std::span<const int> column, std::span<const double> x);

  /// The cage vertex; columns 0 and 16 are the same on both sides.
  [[nodiscard]] std::size_t vertex(int ring, int column, Side side) const;

 private:
  std::array<std::array<std::array<std::size_t, kColumns>, kLastRing + 1>, 2> vertex_{};
};

}  // namespace bimodal::synth
