#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// What a screen is good for.
enum class TimingVerdict : std::uint8_t { Good, Usable, NotForTiming };

/// "good", "usable", "not_for_timing".
[[nodiscard]] std::string_view name(TimingVerdict verdict);

/// What was measured of a screen before the first trial.
struct StartUp {
  std::vector<Duration> intervals;  ///< between flips in a row, each of which drew something
  Duration nominal{};               ///< period of the display mode; 0: it states none
  bool is_seen = false;             ///< the instants were reported or seen, not predicted
  bool by_hardware = false;         ///< stamped by the display hardware or its driver
  bool is_composited = false;       ///< another program puts the window on the screen
  std::string source;               ///< of the instants, in words
};

/// The verdict and its reasons.
struct Gate {
  TimingVerdict verdict = TimingVerdict::NotForTiming;
  std::vector<std::string> reasons;  ///< why not better; empty for Good
  std::size_t flips = 0;
  Duration period{};     ///< median
  Duration deviation{};  ///< standard deviation of the single periods
  Duration longest{};
  std::size_t outliers = 0;  ///< more than 20 % of a period off it
};

/// Not for timing: instants that nobody saw, fewer than 100 flips, a standard deviation above 2 ms,
/// more than 5 % outliers, or a period more than 20 % off the nominal one. Good: at least 100 flips
/// stamped by the hardware or by a swap that waits for it, without a compositor between, of a
/// standard deviation of at most 0.1 ms and at most 1 % outliers. (Psychtoolbox refuses to present
/// unless it has 50 flips with a standard deviation below 0.1 ms within 20 % of the nominal
/// period.) Everything else is usable.
[[nodiscard]] Gate judge(const StartUp& start_up);

}  // namespace bimodal::runner
