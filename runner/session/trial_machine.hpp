#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "runner/session/choice.hpp"
#include "runner/session/keystroke.hpp"
#include "runner/session/text_entry.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// What the world tells a trial. Every event carries the instant at which it happened.
struct FixationShown {
  Instant at;
};

/// Time zero of the recording, seen or heard, whichever comes first.
struct OnsetPassed {
  Instant at;
};

struct StimulusEnded {
  Instant at;
};

struct Tick {
  Instant at;
};

using TrialEvent = std::variant<FixationShown, OnsetPassed, StimulusEnded, Keystroke, Tick>;

/// What a trial asks of the world; nothing here touches a device.
struct StartStimulus {
  Instant earliest;
};

/// The answer has been given while the stimulus is still on; RecordResponse follows it.
struct NoteEarlyAnswer {
  Instant at;
};

struct RecordResponse {
  std::string text;  ///< empty: an omission
  Instant submitted;
  std::optional<Instant> first_key;  ///< of a choice: the first one that was made
  bool timed_out = false;
  /// Of `submitted`, by the stamp of the stroke that submitted it; absent: the time ran out.
  std::optional<Duration> uncertainty{};
};

struct StopSession {
  Instant at;
};

using TrialCommand = std::variant<StartStimulus, NoteEarlyAnswer, RecordResponse, StopSession>;

struct TrialRules {
  Duration fixation{};                 ///< from fixation onset to the stimulus
  std::optional<Duration> time_limit;  ///< from stimulus end; absent: none
  std::size_t longest_answer = 40;     ///< code points
  std::optional<ChoiceRules> choice;   ///< absent: answers are typed
  bool from_onset = false;             ///< a choice may be made during the stimulus
};

/// The life of one trial: fixation, stimulus, answer, typed or chosen. A typed answer ends by
/// Enter; a choice by itself or, if it is to be confirmed, by Enter. What was pressed before the
/// stimulus ended, by its stamp, chooses nothing. Where answers count from the onset, keys and
/// buttons that were pressed after it are taken during the stimulus, which goes on to its end all
/// the same; clicks are not, for there is nothing to click yet. Escape (or closing the window) asks
/// for confirmation at any time; the question is put once the stimulus has ended. Escape again
/// stops the session, Enter goes back to the answer. A pure state machine: a recorded session can
/// be replayed event by event.
class TrialMachine {
 public:
  explicit TrialMachine(TrialRules rules)
      : rules_{std::move(rules)}, entry_{rules_.longest_answer} {}

  [[nodiscard]] std::vector<TrialCommand> on(const TrialEvent& event);

  enum class Phase { AwaitingFixation, Presenting, Responding, Confirming, Finished };

  [[nodiscard]] Phase phase() const { return phase_; }

  /// Whether strokes belong to the answer now.
  [[nodiscard]] bool takes_answer() const;

  /// Whether the answer was given during the stimulus.
  [[nodiscard]] bool answered_early() const { return early_.has_value(); }

  /// What has been typed so far.
  [[nodiscard]] const std::string& answer() const { return entry_.text(); }

  /// The option that is chosen so far.
  [[nodiscard]] std::optional<std::size_t> chosen() const { return chosen_; }

 private:
  [[nodiscard]] std::vector<TrialCommand> on_stimulus_end(Instant at);
  [[nodiscard]] std::vector<TrialCommand> on_keystroke(const Keystroke& stroke);
  [[nodiscard]] std::vector<TrialCommand> on_early_key(const Keystroke& stroke);
  [[nodiscard]] std::vector<TrialCommand> on_answer_key(const Keystroke& stroke);
  [[nodiscard]] std::vector<TrialCommand> on_confirmation(const Keystroke& stroke);
  /// Whether the stroke completes the answer.
  [[nodiscard]] bool type(const Keystroke& stroke);
  [[nodiscard]] bool choose(const Keystroke& stroke);
  [[nodiscard]] std::vector<TrialCommand> finish(RecordResponse response);
  [[nodiscard]] RecordResponse response_at(const Keystroke& stroke) const;
  [[nodiscard]] std::string text() const;

  TrialRules rules_;
  TextEntry entry_;
  Phase phase_ = Phase::AwaitingFixation;
  bool stop_asked_ = false;
  std::optional<Instant> onset_;  ///< from which answers count; absent: not yet, or from the end
  Instant stimulus_end_;
  std::optional<Instant> first_key_;
  std::optional<std::size_t> chosen_;
  std::optional<RecordResponse> early_;  ///< given during the stimulus
};

}  // namespace bimodal::runner
