#pragma once

#include <optional>
#include <span>
#include <vector>

#include "stimuli/timeline/utterance.hpp"

namespace bimodal::synth {

/// A measure in the course of time; borrowed. Times in ms increase.
struct Course {
  std::span<const double> time_ms;
  std::span<const double> values;
};

/// Lips are counted as shut below this inner height (the tracker reads up to .2 mm for lips that
/// touch, and more where one picture in 40 ms meets the release).
inline constexpr double kShutMm = 0.7;

/// P, B or M; W, WH or UW.
[[nodiscard]] bool closes_lips(Phone phone);
[[nodiscard]] bool rounds_lips(Phone phone);

/// When the lips come nearest to each other for a phone.
struct Closure {
  double lowest_mm = 0;
  /// Middle of the stretch that is within 0.5 mm of the lowest; absent if lips do not close and
  /// open again for this phone.
  std::optional<double> time_ms;
};

/// The lowest inner height from 120 ms before the phone to 60 ms behind it; absent where the course
/// has fewer than three instants there.
[[nodiscard]] std::optional<Closure> closure(const Course& inner_height, const TimedPhone& phone);

/// When the lips become narrow for a phone.
struct Rounding {
  double fall_mm = 0;      ///< from the widest in the 400 ms before the narrowest
  double half_way_ms = 0;  ///< when half of the fall was reached
  double narrowest_ms = 0;
};

/// The least width from 100 ms before the phone to 150 ms behind it; absent if it is at either end
/// of that window, or less than `least_fall_mm` below the widest.
[[nodiscard]] std::optional<Rounding> rounding(const Course& outer_width,
                                               const TimedPhone& phone,
                                               double least_fall_mm);

/// Median and standard deviation (n - 1).
struct Middle {
  std::size_t count = 0;
  double median = 0;         ///< meaningless where count is 0
  std::optional<double> sd;  ///< of two or more
};

[[nodiscard]] Middle middle_of(std::vector<double> values);

}  // namespace bimodal::synth
