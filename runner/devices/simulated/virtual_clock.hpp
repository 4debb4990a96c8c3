#pragma once

#include <cassert>

#include "runner/devices/clock.hpp"

namespace bimodal::runner {

/// Time that passes only when it is told to. For one thread.
class VirtualClock final : public Clock {
 public:
  explicit VirtualClock(Instant start = Instant{}) : now_{start} {}

  [[nodiscard]] Instant now() const override { return now_; }

  /// Never goes back: an instant in the past changes nothing.
  void advance_to(Instant instant) {
    if (instant > now_) now_ = instant;
  }

  /// By a duration >= 0.
  void advance_by(Duration duration) {
    assert(duration >= Duration::zero());
    now_ += duration;
  }

 private:
  Instant now_;
};

}  // namespace bimodal::runner
