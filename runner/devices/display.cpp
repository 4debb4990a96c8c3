#include "runner/devices/display.hpp"

namespace bimodal::runner {

std::string_view name(TimeSource source) {
  switch (source) {
    case TimeSource::Predicted:
      return "predicted";
    case TimeSource::SwapReturned:
      return "swap_returned";
    case TimeSource::DriverReported:
      return "driver_reported";
    case TimeSource::Photodiode:
      return "photodiode";
  }
  return "unknown";
}

Instant nearest_refresh(const RefreshEstimate& estimate, Instant wanted) {
  const auto period = estimate.period.count();
  if (period <= 0) return wanted;
  const auto since = (wanted - estimate.phase).count();
  const auto doubled = 2 * since + period;  // floor((since + period / 2) / period), exactly
  const auto refreshes =
      doubled >= 0 ? doubled / (2 * period) : -((-doubled + 2 * period - 1) / (2 * period));
  return estimate.phase + Duration{refreshes * period};
}

}  // namespace bimodal::runner
