#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/booth/booth.hpp"
#include "runner/booth/flash_trial.hpp"
#include "runner/store/records.hpp"

namespace bimodal::runner {

/// One flash with its beep.
struct TimedTrial {
  TrialRecord record;                   ///< as a session would store it
  std::optional<Duration> visual;       ///< reported onset, session clock
  std::optional<Duration> auditory;     ///< reported onset, session clock
  std::optional<Duration> true_visual;  ///< by the photodiode, session clock
  std::optional<Duration> true_auditory;
};

struct TimingPlan {
  int trials = 100;
  FlashTrial flash;
  Duration shortest_fixation = std::chrono::milliseconds{300};
  Duration longest_fixation = std::chrono::milliseconds{600};  ///< each in between is as likely
  Seed seed = 1;
};

/// Presents the flashes as a session presents its trials. `after` is told of each trial; `stopped`
/// ends the run before the next one.
[[nodiscard]] std::vector<TimedTrial> run_timing(const Booth& booth,
                                                 const TimingPlan& plan,
                                                 const std::function<void(int, TimedTrial&)>& after,
                                                 const std::function<bool()>& stopped);

}  // namespace bimodal::runner
