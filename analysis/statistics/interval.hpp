#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

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

/// Intervals of a proportion of independent trials.
enum class IntervalMethod {
  Wilson,
  /// With continuity correction (Newcombe, 1998, Stat. Med. 17, 857-872, his method 4).
  WilsonCorrected,
  /// Exact, and so too wide on average (Clopper & Pearson, 1934, Biometrika 26, 404-413).
  ClopperPearson,
  /// Quantiles of the Beta(k + 1/2, n - k + 1/2) distribution; 0 and 1 at the ends.
  Jeffreys,
  /// Wald's around Wilson's centre (Agresti & Coull, 1998, Am. Stat. 52, 119-126), cut at 0 and 1.
  AgrestiCoull,
};

inline constexpr std::array kIntervalMethods{IntervalMethod::Wilson,
                                             IntervalMethod::WilsonCorrected,
                                             IntervalMethod::ClopperPearson,
                                             IntervalMethod::Jeffreys,
                                             IntervalMethod::AgrestiCoull};

/// "wilson", "wilson-cc", "clopper-pearson", "jeffreys", "agresti-coull".
[[nodiscard]] std::string_view name(IntervalMethod method);

/// Of `successes` of `trials`, at a level within (0, 1); absent if there were no trials.
[[nodiscard]] std::optional<Interval> interval_of(IntervalMethod method,
                                                  std::int64_t successes,
                                                  std::int64_t trials,
                                                  double level = 0.95);

}  // namespace bimodal::analysis
