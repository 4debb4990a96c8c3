#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "runner/session/keystroke.hpp"
#include "runner/session/text_entry.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// What the world tells a trial. Every event carries the instant at which it happened.
struct FixationShown {
  Instant at;
};

struct StimulusEnded {
  Instant at;
};

struct Tick {
  Instant at;
};

using TrialEvent = std::variant<FixationShown, StimulusEnded, Keystroke, Tick>;

/// What a trial asks of the world; nothing here touches a device.
struct StartStimulus {
  Instant earliest;
};

struct RecordResponse {
  std::string text;  ///< empty: an omission
  Instant submitted;
  std::optional<Instant> first_key;
  bool timed_out = false;
};

struct StopSession {
  Instant at;
};

using TrialCommand = std::variant<StartStimulus, RecordResponse, StopSession>;

struct TrialRules {
  Duration fixation{};                 ///< from fixation onset to the stimulus
  std::optional<Duration> time_limit;  ///< from stimulus end; absent: none
  std::size_t longest_answer = 40;     ///< code points
};

/// The life of one trial: fixation, stimulus, typed answer. Escape (or closing the window) asks for
/// confirmation at any time; the question is put once the stimulus has ended. Escape again stops
/// the session, Enter goes back to the answer. Clicks and buttons do nothing. A pure state machine:
/// a recorded session can be replayed event by event.
class TrialMachine {
 public:
  explicit TrialMachine(const TrialRules& rules) : rules_{rules}, entry_{rules.longest_answer} {}

  [[nodiscard]] std::vector<TrialCommand> on(const TrialEvent& event);

  enum class Phase { AwaitingFixation, Presenting, Responding, Confirming, Finished };

  [[nodiscard]] Phase phase() const { return phase_; }

  [[nodiscard]] const std::string& answer() const { return entry_.text(); }

 private:
  [[nodiscard]] std::vector<TrialCommand> on_keystroke(const Keystroke& stroke);
  [[nodiscard]] std::vector<TrialCommand> on_answer_key(const Keystroke& stroke);
  [[nodiscard]] std::vector<TrialCommand> finish(Instant at, bool timed_out);

  TrialRules rules_;
  TextEntry entry_;
  Phase phase_ = Phase::AwaitingFixation;
  bool stop_asked_ = false;
  Instant stimulus_end_;
  std::optional<Instant> first_key_;
};

}  // namespace bimodal::runner
