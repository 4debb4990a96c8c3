#pragma once

#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// The session clock: CLOCK_MONOTONIC, or virtual time in a rehearsal.
class Clock {
 public:
  Clock() = default;
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;
  Clock(Clock&&) = delete;
  Clock& operator=(Clock&&) = delete;
  virtual ~Clock() = default;

  [[nodiscard]] virtual Instant now() const = 0;
};

}  // namespace bimodal::runner
