#include "analysis/statistics/interval.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace bimodal::analysis {

std::optional<Interval> wilson(std::int64_t successes, std::int64_t trials, double z) {
  assert(successes >= 0 && successes <= trials && z >= 0.0);
  if (trials == 0) return std::nullopt;
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(successes) / n;
  const double centre = p + z * z / (2.0 * n);
  const double reach = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  const double scale = 1.0 + z * z / n;
  // Exact at the ends, where rounding would leave 1e-17 or 1 - 1e-16.
  return Interval{successes == 0 ? 0.0 : std::max(0.0, (centre - reach) / scale),
                  successes == trials ? 1.0 : std::min(1.0, (centre + reach) / scale)};
}

}  // namespace bimodal::analysis
