#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// How a set of durations is distributed.
struct Moments {
  std::size_t count = 0;
  double mean_ms = 0.0;
  double deviation_ms = 0.0;  ///< standard deviation, n - 1; 0 for fewer than two
  double median_ms = 0.0;
  double smallest_ms = 0.0;
  double largest_ms = 0.0;
  double largest_magnitude_ms = 0.0;
};

/// All zero without durations.
[[nodiscard]] Moments moments_of(std::span<const Duration> durations);

/// A stretch of a histogram.
struct Bin {
  double from_ms = 0.0;  ///< up to, not including, from_ms + width
  std::size_t count = 0;
};

/// Bins of equal width, of 1, 2 or 5 times a power of ten ms, that begin at multiples of it: as few
/// as cover everything, at most `most` (>= 2). Empty without durations.
struct Histogram {
  double width_ms = 0.0;
  std::vector<Bin> bins;
};

[[nodiscard]] Histogram histogram_of(std::span<const Duration> durations, std::size_t most = 20);

/// One line a bin: where it begins, a bar of at most `columns` signs, its count.
[[nodiscard]] std::string draw(const Histogram& histogram, std::size_t columns = 50);

}  // namespace bimodal::runner
