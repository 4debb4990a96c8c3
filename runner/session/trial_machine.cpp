#include "runner/session/trial_machine.hpp"

#include "runner/session/match.hpp"

namespace bimodal::runner {

std::vector<TrialCommand> TrialMachine::on(const TrialEvent& event) {
  return std::visit(Match{[this](const FixationShown& shown) -> std::vector<TrialCommand> {
                            if (phase_ != Phase::AwaitingFixation) return {};
                            phase_ = Phase::Presenting;
                            return {StartStimulus{shown.at + rules_.fixation}};
                          },
                          [this](const OnsetPassed& onset) -> std::vector<TrialCommand> {
                            if (phase_ == Phase::Presenting && rules_.from_onset) onset_ = onset.at;
                            return {};
                          },
                          [this](const StimulusEnded& ended) { return on_stimulus_end(ended.at); },
                          [this](const Keystroke& stroke) { return on_keystroke(stroke); },
                          [this](const Tick& tick) -> std::vector<TrialCommand> {
                            if (phase_ != Phase::Responding || !rules_.time_limit) return {};
                            if (tick.at - stimulus_end_ < *rules_.time_limit) return {};
                            return finish({.text = text(),
                                           .submitted = tick.at,
                                           .first_key = first_key_,
                                           .timed_out = true});
                          }},
                    event);
}

bool TrialMachine::takes_answer() const {
  return phase_ == Phase::Responding || (phase_ == Phase::Presenting && onset_ && !early_);
}

std::vector<TrialCommand> TrialMachine::on_stimulus_end(Instant at) {
  if (phase_ != Phase::Presenting) return {};
  stimulus_end_ = at;
  phase_ = stop_asked_ ? Phase::Confirming : Phase::Responding;
  if (stop_asked_ || !early_) return {};
  return finish(*early_);
}

std::vector<TrialCommand> TrialMachine::on_keystroke(const Keystroke& stroke) {
  switch (phase_) {
    case Phase::AwaitingFixation:
    case Phase::Presenting:
      return on_early_key(stroke);
    case Phase::Responding:
      return on_answer_key(stroke);
    case Phase::Confirming:
      return on_confirmation(stroke);
    case Phase::Finished:
      return {};
  }
  return {};
}

std::vector<TrialCommand> TrialMachine::on_early_key(const Keystroke& stroke) {
  stop_asked_ = stop_asked_ || asks_to_stop(stroke);
  const bool counts = takes_answer() && stroke.key != Key::Pointer;
  if (!counts || !rules_.choice || !choose(stroke)) return {};
  early_ = response_at(stroke);
  return {NoteEarlyAnswer{stroke.at}};
}

std::vector<TrialCommand> TrialMachine::on_answer_key(const Keystroke& stroke) {
  if (asks_to_stop(stroke)) {
    phase_ = Phase::Confirming;
    return {};
  }
  const bool complete = rules_.choice ? choose(stroke) : type(stroke);
  if (!complete) return {};
  return finish(response_at(stroke));
}

std::vector<TrialCommand> TrialMachine::on_confirmation(const Keystroke& stroke) {
  if (asks_to_stop(stroke)) {
    phase_ = Phase::Finished;
    return {StopSession{stroke.at}};
  }
  if (stroke.key != Key::Enter) return {};
  phase_ = Phase::Responding;
  if (!early_) return {};
  return finish(*early_);
}

bool TrialMachine::type(const Keystroke& stroke) {
  if (stroke.key == Key::Enter) return true;
  if (is_button_press(stroke)) return false;
  if (stroke.key == Key::Left) return false;  // moves nothing: answers are typed at their end
  if (!first_key_) first_key_ = stroke.at;
  if (stroke.key == Key::Backspace) entry_.erase();
  if (stroke.key == Key::Text) entry_.type(stroke.text);
  return false;
}

bool TrialMachine::choose(const Keystroke& stroke) {
  const auto& choice = *rules_.choice;
  if (stroke.key == Key::Enter) return choice.confirm && chosen_.has_value();
  const auto option = option_of(choice, stroke);
  if (!option || stroke.at < onset_.value_or(stimulus_end_)) return false;
  if (!first_key_) first_key_ = stroke.at;
  chosen_ = option;
  return !choice.confirm;
}

RecordResponse TrialMachine::response_at(const Keystroke& stroke) const {
  return {.text = text(),
          .submitted = stroke.at,
          .first_key = first_key_,
          .uncertainty = stroke.uncertainty};
}

std::string TrialMachine::text() const {
  if (!rules_.choice) return entry_.text();
  return chosen_ ? rules_.choice->options.at(*chosen_).label : std::string{};
}

std::vector<TrialCommand> TrialMachine::finish(RecordResponse response) {
  phase_ = Phase::Finished;
  return {std::move(response)};
}

}  // namespace bimodal::runner
