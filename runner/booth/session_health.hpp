#pragma once

#include <algorithm>

#include "runner/session/progress.hpp"
#include "runner/store/records.hpp"
#include "runner/timing/refresh_estimate.hpp"

namespace bimodal::runner {

/// Counts what went wrong with display and sound, over a session. Pure.
class SessionHealth {
 public:
  /// `period` of the refresh; `underflows` during the trial's sound.
  void add(const TrialRecord& trial, Duration period, std::int64_t underflows);

  void note_lost_sound() { health_.sound_lost = true; }

  /// How long after its last stroke an answer was on the disk.
  void note_storing(Duration delay) {
    health_.longest_storing = std::max(health_.longest_storing, delay);
  }

  [[nodiscard]] Health at(Instant instant, const RefreshEstimate& refresh) const;

 private:
  Health health_;
};

}  // namespace bimodal::runner
