#include "runner/session/trial_machine.hpp"

#include "runner/session/match.hpp"

namespace bimodal::runner {

std::vector<TrialCommand> TrialMachine::on(const TrialEvent& event) {
  return std::visit(Match{[this](const FixationShown& shown) -> std::vector<TrialCommand> {
                            if (phase_ != Phase::AwaitingFixation) return {};
                            phase_ = Phase::Presenting;
                            return {StartStimulus{shown.at + rules_.fixation}};
                          },
                          [this](const StimulusEnded& ended) -> std::vector<TrialCommand> {
                            if (phase_ != Phase::Presenting) return {};
                            phase_ = stop_asked_ ? Phase::Confirming : Phase::Responding;
                            stimulus_end_ = ended.at;
                            return {};
                          },
                          [this](const Keystroke& stroke) { return on_keystroke(stroke); },
                          [this](const Tick& tick) -> std::vector<TrialCommand> {
                            if (phase_ != Phase::Responding || !rules_.time_limit) return {};
                            if (tick.at - stimulus_end_ < *rules_.time_limit) return {};
                            return finish(tick.at, true);
                          }},
                    event);
}

std::vector<TrialCommand> TrialMachine::on_keystroke(const Keystroke& stroke) {
  switch (phase_) {
    case Phase::AwaitingFixation:
    case Phase::Presenting:
      stop_asked_ = stop_asked_ || asks_to_stop(stroke);
      return {};
    case Phase::Responding:
      return on_answer_key(stroke);
    case Phase::Confirming:
      if (stroke.key == Key::Enter) phase_ = Phase::Responding;
      if (!asks_to_stop(stroke)) return {};
      phase_ = Phase::Finished;
      return {StopSession{stroke.at}};
    case Phase::Finished:
      return {};
  }
  return {};
}

std::vector<TrialCommand> TrialMachine::on_answer_key(const Keystroke& stroke) {
  if (asks_to_stop(stroke)) {
    phase_ = Phase::Confirming;
    return {};
  }
  if (stroke.key == Key::Enter) return finish(stroke.at, false);
  if (is_button_press(stroke)) return {};
  if (stroke.key == Key::Left) return {};  // moves nothing: answers are typed at their end
  if (!first_key_) first_key_ = stroke.at;
  if (stroke.key == Key::Backspace) entry_.erase();
  if (stroke.key == Key::Text) entry_.type(stroke.text);
  return {};
}

std::vector<TrialCommand> TrialMachine::finish(Instant at, bool timed_out) {
  phase_ = Phase::Finished;
  return {RecordResponse{entry_.text(), at, first_key_, timed_out}};
}

}  // namespace bimodal::runner
