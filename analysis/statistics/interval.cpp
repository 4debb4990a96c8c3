#include "analysis/statistics/interval.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/normal.hpp>

namespace bimodal::analysis {

namespace {

double beta_quantile(double a, double b, double part) {
  return boost::math::quantile(boost::math::beta_distribution<>{a, b}, part);
}

/// Where the score test, its difference made smaller by 1/2n, just does not reject.
Interval wilson_corrected(double k, double n, double z) {
  const double p = k / n;
  const double q = 1.0 - p;
  const double scale = 2.0 * (n + z * z);
  const double low =
      (2.0 * k + z * z - 1.0 -
       z * std::sqrt(std::max(0.0, z * z - 2.0 - 1.0 / n + 4.0 * p * (n * q + 1.0)))) /
      scale;
  const double high =
      (2.0 * k + z * z + 1.0 +
       z * std::sqrt(std::max(0.0, z * z + 2.0 - 1.0 / n + 4.0 * p * (n * q - 1.0)))) /
      scale;
  return {k == 0.0 ? 0.0 : std::max(0.0, low), k == n ? 1.0 : std::min(1.0, high)};
}

Interval agresti_coull(double k, double n, double z) {
  const double more = n + z * z;
  const double centre = (k + z * z / 2.0) / more;
  const double reach = z * std::sqrt(centre * (1.0 - centre) / more);
  return {std::max(0.0, centre - reach), std::min(1.0, centre + reach)};
}

/// Beta quantiles of k and n - k, each more by so much; 0 and 1 at the ends.
Interval between_quantiles(double k, double n, double tail, double more_low, double more_high) {
  return {k == 0.0 ? 0.0 : beta_quantile(k + more_low, n - k + more_high, tail),
          k == n ? 1.0 : beta_quantile(k + more_high, n - k + more_low, 1.0 - tail)};
}

}  // namespace

std::string_view name(IntervalMethod method) {
  constexpr std::array<std::string_view, kIntervalMethods.size()> kNames{
      "wilson", "wilson-cc", "clopper-pearson", "jeffreys", "agresti-coull"};
  return kNames.at(static_cast<std::size_t>(method));
}

std::optional<Interval> interval_of(IntervalMethod method,
                                    std::int64_t successes,
                                    std::int64_t trials,
                                    double level) {
  assert(successes >= 0 && successes <= trials && level > 0.0 && level < 1.0);
  if (trials == 0) return std::nullopt;
  const auto k = static_cast<double>(successes);
  const auto n = static_cast<double>(trials);
  const double tail = (1.0 - level) / 2.0;
  const double z = -boost::math::quantile(boost::math::normal_distribution<>{}, tail);
  switch (method) {
    case IntervalMethod::Wilson:
      break;
    case IntervalMethod::WilsonCorrected:
      return wilson_corrected(k, n, z);
    case IntervalMethod::ClopperPearson:
      return between_quantiles(k, n, tail, 0.0, 1.0);
    case IntervalMethod::Jeffreys:
      return between_quantiles(k, n, tail, 0.5, 0.5);
    case IntervalMethod::AgrestiCoull:
      return agresti_coull(k, n, z);
  }
  return wilson(successes, trials, z);
}

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
