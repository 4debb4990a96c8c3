#include "runner/session/recording_machine.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "runner/session/match.hpp"

namespace bimodal::runner {

namespace {

using namespace std::chrono_literals;

/// Window systems repeat a held key after 0.5 to 0.7 s, then some 30 times a second.
constexpr Duration kBeforeRepeats = 800ms;
constexpr Duration kBetweenRepeats = 100ms;

bool is_letter(const Keystroke& stroke, char lower, char upper) {
  return stroke.key == Key::Text && stroke.text.size() == 1 &&
         (stroke.text.front() == lower || stroke.text.front() == upper);
}

bool is_go(const Keystroke& stroke) {
  return stroke.key == Key::Enter || is_letter(stroke, ' ', ' ');
}

bool is_again(const Keystroke& stroke) {
  return stroke.key == Key::Backspace || is_letter(stroke, 'r', 'R');
}

bool is_pass(const Keystroke& stroke) {
  return is_letter(stroke, 's', 'S');
}

bool is_keep(const Keystroke& stroke) {
  return is_letter(stroke, 'k', 'K');
}

}  // namespace

RecordingMachine::RecordingMachine(std::vector<RecordingSlot> slots, const RecordingRules& rules)
    : slots_{std::move(slots)}, passed_over_(slots_.size(), false), rules_{rules} {
  assert(!slots_.empty());
  const auto first = std::ranges::find(slots_, false, &RecordingSlot::done);
  if (first != slots_.end()) slot_ = static_cast<std::size_t>(first - slots_.begin());
}

std::size_t RecordingMachine::done() const {
  return static_cast<std::size_t>(std::ranges::count(slots_, true, &RecordingSlot::done));
}

bool RecordingMachine::awaits_key() const {
  switch (phase_) {
    case Phase::Welcome:
    case Phase::RoomDoubt:
    case Phase::Confirming:
    case Phase::Complete:
      return true;
    case Phase::Ready:
      return !rules_.automatic || slots_[slot_].done || attempts_ >= rules_.attempts;
    case Phase::Doubt:
      return !rules_.automatic || attempts_ >= rules_.attempts;
    default:
      return false;
  }
}

RecordingMachine::Commands RecordingMachine::on(const RecordingEvent& event) {
  return std::visit(Match{[this](const Moment& moment) { return on_moment(moment); },
                          [this](const Keystroke& stroke) { return on_key(stroke); },
                          [this](const RoomJudged& judged) -> Commands {
                            if (phase_ != Phase::RoomJudging) return {};
                            if (!judged.quiet) {
                              enter(Phase::RoomDoubt, judged.at);
                            } else {
                              go_on(judged.at);
                            }
                            return {};
                          },
                          [this](const TakeJudged& judged) { return on_take(judged); }},
                    event);
}

RecordingMachine::Commands RecordingMachine::on_moment(const Moment& moment) {
  const auto spent = moment.at - since_;
  switch (phase_) {
    case Phase::Room:
      if (spent < rules_.room) return {};
      enter(Phase::RoomJudging, moment.at);
      return {EndRoom{}};
    case Phase::Ready:
      if (!awaits_key() && spent >= rules_.reading) enter(Phase::Arming, moment.at);
      return {};
    case Phase::Arming:
      if (spent < rules_.arming) return {};
      enter(Phase::Recording, moment.at);
      return {BeginCapture{}};
    case Phase::Recording:
      if (spent < rules_.limit && (!moment.silence || *moment.silence < rules_.silence)) return {};
      enter(Phase::TakeJudging, moment.at);
      return {EndTake{slot_}};
    case Phase::Praise:
      if (spent >= rules_.praise) go_on(moment.at);
      return {};
    case Phase::Doubt:
      if (!awaits_key() && spent >= rules_.reproof) enter(Phase::Arming, moment.at);
      return {};
    default:
      return {};
  }
}

bool RecordingMachine::is_held_key(const Keystroke& stroke) {
  const bool held = last_stroke_ && last_stroke_->key == stroke.key &&
                    last_stroke_->text == stroke.text &&
                    stroke.at - last_stroke_->at < kBetweenRepeats;
  last_stroke_ = stroke;
  return held;
}

RecordingMachine::Commands RecordingMachine::on_key(const Keystroke& stroke) {
  if (is_button_press(stroke)) return {};
  if (is_held_key(stroke)) return {};
  if (phase_ == Phase::Confirming) return on_confirming(stroke);
  if (asks_to_stop(stroke)) return ask_to_stop(stroke.at);
  switch (phase_) {
    case Phase::Welcome:
      return is_go(stroke) ? begin_room(stroke.at) : Commands{};
    case Phase::RoomDoubt:
      if (is_keep(stroke)) go_on(stroke.at);
      return is_go(stroke) || is_again(stroke) ? begin_room(stroke.at) : Commands{};
    case Phase::Ready:
      return on_ready(stroke);
    case Phase::Arming:
    case Phase::Recording:
      return on_recording(stroke);
    case Phase::Praise:
      if (is_go(stroke)) go_on(stroke.at);
      return is_again(stroke) ? again(stroke.at) : Commands{};
    case Phase::Doubt:
      return on_doubt(stroke);
    case Phase::Complete:
      if (is_again(stroke)) return again(stroke.at);
      if (!is_go(stroke)) return {};
      enter(Phase::Ended, stroke.at);
      return {EndRecording{done() == slots_.size()}};
    default:
      return {};
  }
}

RecordingMachine::Commands RecordingMachine::on_take(const TakeJudged& judged) {
  if (phase_ != Phase::TakeJudging) return {};
  if (!judged.good) {
    ++attempts_;
    can_keep_ = judged.kept;
    enter(Phase::Doubt, judged.at);
    return {};
  }
  slots_[slot_].done = true;
  last_ = slot_;
  enter(Phase::Praise, judged.at);
  return {};
}

RecordingMachine::Commands RecordingMachine::on_confirming(const Keystroke& stroke) {
  if (asks_to_stop(stroke)) {
    enter(Phase::Ended, stroke.at);
    return {EndRecording{done() == slots_.size()}};
  }
  if (is_go(stroke)) enter(interrupted_, stroke.at);
  return {};
}

RecordingMachine::Commands RecordingMachine::on_ready(const Keystroke& stroke) {
  if (is_go(stroke)) {
    enter(Phase::Arming, stroke.at);
  } else if (is_again(stroke)) {
    return again(stroke.at);
  } else if (is_pass(stroke)) {
    pass_over(stroke.at);
  } else if (stroke.key == Key::Left && slot_ > 0) {
    show(slot_ - 1, stroke.at);
  }
  return {};
}

RecordingMachine::Commands RecordingMachine::on_recording(const Keystroke& stroke) {
  const bool captures = phase_ == Phase::Recording;
  if (is_go(stroke)) {
    // Sooner it is the key that began the take, held down.
    if (!captures || stroke.at - since_ < kBeforeRepeats) return {};
    enter(Phase::TakeJudging, stroke.at);
    return {EndTake{slot_}};
  }
  const bool goes_back = stroke.key == Key::Left;
  if (!is_again(stroke) && !is_pass(stroke) && !goes_back) return {};
  if (is_pass(stroke)) {
    pass_over(stroke.at);
  } else {
    show(goes_back && slot_ > 0 ? slot_ - 1 : slot_, stroke.at);
  }
  return captures ? Commands{DropCapture{}} : Commands{};
}

RecordingMachine::Commands RecordingMachine::on_doubt(const Keystroke& stroke) {
  if (is_go(stroke) || is_again(stroke)) {
    enter(Phase::Arming, stroke.at);
  } else if (is_pass(stroke)) {
    pass_over(stroke.at);
  } else if (stroke.key == Key::Left && slot_ > 0) {
    show(slot_ - 1, stroke.at);
  } else if (is_keep(stroke) && can_keep_) {
    slots_[slot_].done = true;
    last_ = slot_;
    const auto kept = slot_;
    go_on(stroke.at);
    return {KeepTake{kept}};
  }
  return {};
}

RecordingMachine::Commands RecordingMachine::ask_to_stop(Instant at) {
  switch (phase_) {
    case Phase::RoomJudging:
    case Phase::TakeJudging:
    case Phase::Ended:
      return {};
    case Phase::Room:
    case Phase::Recording:
      interrupted_ = phase_ == Phase::Room ? Phase::Welcome : Phase::Ready;
      enter(Phase::Confirming, at);
      return {DropCapture{}};
    default:
      interrupted_ = phase_ == Phase::Arming ? Phase::Ready : phase_;
      enter(Phase::Confirming, at);
      return {};
  }
}

RecordingMachine::Commands RecordingMachine::again(Instant at) {
  const bool is_shown = phase_ == Phase::Ready && slots_[slot_].done;
  if (!is_shown && !last_) return {};
  const auto meant = is_shown ? slot_ : *last_;
  const bool counted = slots_[meant].done;
  slots_[meant].done = false;
  show(meant, at);
  return counted ? Commands{RejectTake{meant}} : Commands{};
}

RecordingMachine::Commands RecordingMachine::begin_room(Instant at) {
  enter(Phase::Room, at);
  return {BeginCapture{}};
}

void RecordingMachine::pass_over(Instant at) {
  if (!slots_[slot_].done) passed_over_[slot_] = true;
  go_on(at);
}

void RecordingMachine::enter(Phase phase, Instant at) {
  phase_ = phase;
  since_ = at;
}

void RecordingMachine::show(std::size_t slot, Instant at) {
  slot_ = slot;
  attempts_ = 0;
  passed_over_[slot] = false;
  enter(Phase::Ready, at);
}

/// To the next slot that is wanted; from the last one on to those before it.
void RecordingMachine::go_on(Instant at) {
  for (std::size_t step = 0; step < slots_.size(); ++step) {
    const auto next = (slot_ + step) % slots_.size();
    if (slots_[next].done || passed_over_[next]) continue;
    show(next, at);
    return;
  }
  enter(Phase::Complete, at);
}

}  // namespace bimodal::runner
