#include "runner/timing/refresh_estimate.hpp"

#include <cassert>
#include <cmath>
#include <cstdint>

namespace bimodal::runner {
namespace {

std::int64_t floor_divide(std::int64_t dividend, std::int64_t positive_divisor) {
  const auto quotient = dividend / positive_divisor;
  return dividend % positive_divisor < 0 ? quotient - 1 : quotient;
}

}  // namespace

Instant nearest_refresh(const RefreshEstimate& estimate, Instant wanted) {
  const auto period = estimate.period.count();
  if (period <= 0) return wanted;
  const auto since = (wanted - estimate.phase).count();
  return estimate.phase + Duration{floor_divide(2 * since + period, 2 * period) * period};
}

Instant refresh_not_before(const RefreshEstimate& estimate, Instant instant) {
  const auto period = estimate.period.count();
  if (period <= 0) return instant;
  const auto since = (instant - estimate.phase).count();
  return estimate.phase + Duration{-floor_divide(-since, period) * period};
}

Duration period_of(Hertz rate) {
  assert(rate.count() > 0.0);
  return Duration{std::llround(1e9 / rate.count())};
}

}  // namespace bimodal::runner
