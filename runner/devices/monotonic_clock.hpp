#pragma once

#include "runner/devices/clock.hpp"

namespace bimodal::runner {

/// CLOCK_MONOTONIC: nanoseconds since about the start of the machine; steps of wall time do not
/// touch it, it stands still while the machine is suspended. Any thread may use it.
class MonotonicClock final : public Clock {
 public:
  [[nodiscard]] Instant now() const override;
};

/// Sleeps until CLOCK_MONOTONIC reads `instant` or a little later (a fraction of a millisecond on
/// an idle machine); returns at once if it already does. Signals do not wake it.
void sleep_until(Instant instant);

}  // namespace bimodal::runner
