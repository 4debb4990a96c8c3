#pragma once

#include <cstdint>
#include <optional>

namespace bimodal::analysis {

/// A confidence interval of a proportion.
struct Interval {
  double low = 0.0;
  double high = 1.0;

  bool operator==(const Interval&) const = default;
};

/// The normal quantile of a two-sided 95 % interval.
inline constexpr double kZ95 = 1.959963984540054;

/// Wilson's score interval (Wilson, 1927, J. Am. Stat. Assoc. 22, 209-212), without continuity
/// correction: (p + z^2/2n -+ z sqrt(p(1-p)/n + z^2/4n^2)) / (1 + z^2/n). For `successes` of
/// `trials` independent trials; absent if there were none.
[[nodiscard]] std::optional<Interval> wilson(std::int64_t successes,
                                             std::int64_t trials,
                                             double z = kZ95);

}  // namespace bimodal::analysis
