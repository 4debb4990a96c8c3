#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runner/cli/timing_run.hpp"
#include "runner/timing/moments.hpp"
#include "runner/timing/start_up_gate.hpp"

namespace bimodal::runner {

/// What a timing run found.
struct TimingFindings {
  std::string made_utc;
  std::string display;
  std::string audio;
  std::string input;  ///< empty: no instruments
  std::string right_of_way;
  Gate gate;
  Duration intended{};  ///< audio-visual offset
  std::vector<TimedTrial> trials;
  std::int64_t input_lost = 0;  ///< samples
};

/// Over trials after the first that were not flagged, except `flagged`.
struct TimingSummary {
  std::size_t trials = 0;
  std::size_t flagged = 0;
  Moments reported;  ///< reported audio-visual offset minus the intended one
  Moments measured;  ///< the same by instruments
  Moments visual;    ///< true minus reported visual onset
  Moments auditory;  ///< true minus reported auditory onset
  std::size_t unmeasured = 0;
  std::vector<Duration> offsets;  ///< measured if there were instruments, else reported
};

[[nodiscard]] TimingSummary summarise(const TimingFindings& findings);

/// For a terminal: what was measured, a histogram, and what cannot be known.
[[nodiscard]] std::string as_text(const TimingFindings& findings);

/// Everything, every trial and refresh included.
[[nodiscard]] std::string as_json(const TimingFindings& findings);

/// One page for people.
[[nodiscard]] std::string as_page(const TimingFindings& findings);

}  // namespace bimodal::runner
