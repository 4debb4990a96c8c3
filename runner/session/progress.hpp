#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "protocols/design/plan.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

// What a running session tells whoever watches it. Every instant is of the session clock.

/// A page of text waits for the participant.
struct PageShown {
  Instant at;
  std::string text;
  bool is_break = false;
};

enum class TrialState {
  Preparing,  ///< waiting for its sound and pictures
  Fixation,
  Presenting,
  Responding,
  Stored,
};

struct TrialReached {
  Instant at;
  const protocols::PlannedTrial& trial;  ///< borrowed for the call
  std::size_t of = 0;                    ///< trials of the session
  TrialState state = TrialState::Preparing;
};

/// A trial that has been stored.
struct TrialResult {
  Instant at;
  const protocols::PlannedTrial& trial;  ///< borrowed for the call
  std::string response;                  ///< as submitted; empty: an omission
  bool timed_out = false;
  bool flagged = false;                                     ///< timing was not as planned
  std::vector<std::pair<std::string, std::string>> events;  ///< kind and detail, as stored
};

/// How display and sound are doing, since the session began.
struct Health {
  Instant at;
  Duration refresh_period{};              ///< 0: there is no display
  Duration refresh_deviation{};           ///< standard deviation of single periods
  int refreshes_measured = 0;             ///< 0: the period is nominal
  std::int64_t missed_refreshes = 0;      ///< left out while frames followed each other
  std::int64_t late_frames = 0;           ///< shown more than half a refresh late
  std::int64_t underflows = 0;            ///< of the sound
  std::optional<double> sound_drift_ppm;  ///< of the last trial; absent: not measured
  bool sound_lost = false;                ///< the device has stopped asking for samples
  Duration longest_storing{};             ///< from an answer's last stroke until it was on the disk
};

struct PauseChanged {
  enum class State {
    Running,
    Asked,  ///< takes effect between trials
    Paused,
  };
  Instant at;
  State state = State::Running;
  std::string reason;  ///< why it is to be, or is, paused
};

struct SessionEnded {
  Instant at;
  std::string outcome;  ///< "complete", "stopped", "failed"
  std::string detail;   ///< why it failed
};

using Progress =
    std::variant<PageShown, TrialReached, TrialResult, Health, PauseChanged, SessionEnded>;

/// What somebody outside asks of a running session. None takes effect within a stimulus.
enum class Request {
  Pause,   ///< between trials: an answer that has been begun is finished and stored before
  Resume,  ///< also takes a pause back that has not begun
  Stop,    ///< at once, but after a stimulus; a trial that is not answered is not stored
};

}  // namespace bimodal::runner
