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

}  // namespace bimodal::runner
