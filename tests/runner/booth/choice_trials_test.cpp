#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/session/option_grid.hpp"
#include "tests/runner/booth/session_fixture.hpp"

namespace bimodal::runner {
namespace {

class ChoiceTrialsTest : public SessionLoopTest {};

/// Gives one stroke at a fixed time of each trial, counted from the first fixation mark after the
/// pointer was hidden or a page; remembers whether the pointer is shown.
class ChoosingKeyboard final : public Keyboard {
 public:
  ChoosingKeyboard(VirtualClock& clock, SimulatedDisplay& display, Keystroke stroke, Duration after)
      : clock_{clock}, stroke_{std::move(stroke)}, after_{after} {
    display.observe([this](const Screen& screen, const Presentation& shown) {
      if (screen.fixation && !was_fixation_) due_ = shown.onset + after_;
      was_fixation_ = screen.fixation;
      if (!screen.captions.empty()) answer_screens_.push_back(screen);
      if (screen.captions.empty() && pointer_shown) pointer_outside = true;
    });
  }

  std::vector<Keystroke> poll() override {
    if (!due_ || clock_.now() < *due_) return {};
    auto stroke = stroke_;
    stroke.at = *due_;
    due_.reset();
    return {stroke};
  }

  void expect(std::string_view, Instant) override {}

  void show_pointer(bool shown) override { pointer_shown = shown; }

  [[nodiscard]] std::string description() const override { return "choosing"; }

  [[nodiscard]] const std::vector<Screen>& answer_screens() const { return answer_screens_; }

  bool pointer_shown = false;
  bool pointer_outside = false;  ///< while no question was on the screen

 private:
  VirtualClock& clock_;
  Keystroke stroke_;
  Duration after_;
  bool was_fixation_ = false;
  std::optional<Instant> due_;
  std::vector<Screen> answer_screens_;
};

protocols::Response choice() {
  return {.kind = protocols::ResponseKind::Choice,
          .prompt = "ba or wa?",
          .options = {{.label = "ba", .key = "b", .button = 7}, {.label = "wa", .key = "w"}}};
}

TEST_F(ChoiceTrialsTest, StoresTheLabelOfAChoiceWithItsStrokeAndUncertainty) {
  protocol_.instructions.clear();
  protocol_.farewell.clear();
  protocol_.response = choice();
  ChoosingKeyboard keyboard{
      clock_,
      display_,
      {.key = Key::Button, .uncertainty = 3ms, .source = "evdev", .button = 7},
      4s};
  static_cast<void>(run(2, &keyboard));
  ASSERT_EQ(store_.trials.size(), 2U);
  for (const auto& trial : store_.trials) {
    EXPECT_EQ(trial.response.text, "ba");
    EXPECT_EQ(trial.response.uncertainty, 3ms);
    EXPECT_EQ(trial.response.reference_at, trial.stimulus_end);
    ASSERT_EQ(trial.keystrokes.size(), 1U);
    EXPECT_EQ(trial.keystrokes[0].key, "Button7");
    EXPECT_EQ(trial.keystrokes[0].at, trial.response.submitted);
  }
  const auto& screen = keyboard.answer_screens().at(0);
  EXPECT_EQ(screen.marks.size(), 2U);
  EXPECT_EQ(screen.captions.at(0).text, "ba or wa?");
  EXPECT_EQ(screen.captions.at(1).text, "ba");
  EXPECT_EQ(screen.captions.at(2).text, "b");
}

TEST_F(ChoiceTrialsTest, TakesClicksIntoTheBoxesThatAreShownAndHidesThePointerAfterwards) {
  protocol_.instructions.clear();
  protocol_.farewell.clear();
  protocol_.response = choice();
  protocol_.response.pointer = true;
  const auto grid = grid_of(protocol_.response.options, 1.25);
  ChoosingKeyboard keyboard{clock_,
                            display_,
                            {.key = Key::Pointer,
                             .button = 1,
                             .x = grid.boxes.at(1).centre_x,
                             .y = grid.boxes.at(1).centre_y},
                            4s};
  static_cast<void>(run(1, &keyboard));
  EXPECT_EQ(store_.trials.at(0).response.text, "wa");
  EXPECT_EQ(store_.trials.at(0).keystrokes.at(0).x, grid.boxes[1].centre_x);
  EXPECT_FALSE(keyboard.pointer_shown);
  EXPECT_FALSE(keyboard.pointer_outside);
  const auto& marks = keyboard.answer_screens().at(0).marks;
  EXPECT_EQ(marks.at(1).centre_x, grid.boxes[1].centre_x);
}

TEST_F(ChoiceTrialsTest, EndsATrialAfterTheStimulusIfItWasAnsweredDuringIt) {
  protocol_.instructions.clear();
  protocol_.farewell.clear();
  protocol_.response = choice();
  protocol_.response.from = protocols::AnswersFrom::Onset;
  protocol_.response.rt_from = protocols::RtFrom::SoundOnset;
  ChoosingKeyboard keyboard{clock_, display_, {.key = Key::Text, .text = "w"}, 1'600ms};
  static_cast<void>(run(1, &keyboard));
  const auto& trial = store_.trials.at(0);
  EXPECT_EQ(trial.response.text, "wa");
  EXPECT_EQ(trial.refreshes.frame.size(), 102U);  // shown to its end
  EXPECT_LT(trial.response.submitted, trial.stimulus_end);
  EXPECT_GT(trial.response.submitted, *trial.response.reference_at);
  EXPECT_EQ(trial.keystrokes.size(), 1U);
  EXPECT_TRUE(keyboard.answer_screens().empty());
  const auto responses = std::ranges::count(trial.triggers, "response", &TriggerRecord::event);
  EXPECT_EQ(responses, 1);
  EXPECT_EQ(trial.triggers.back().event, "stimulus_end");  // the answer was told before
}

TEST_F(ChoiceTrialsTest, TakesNoAnswerBeforeTheOnset) {
  protocol_.instructions.clear();
  protocol_.farewell.clear();
  protocol_.response = choice();
  protocol_.response.from = protocols::AnswersFrom::Onset;
  protocol_.response.time_limit = 200ms;
  ChoosingKeyboard keyboard{clock_, display_, {.key = Key::Text, .text = "w"}, 900ms};
  static_cast<void>(run(1, &keyboard));
  EXPECT_TRUE(store_.trials.at(0).response.timed_out);
  EXPECT_EQ(store_.trials.at(0).response.text, "");
}

}  // namespace
}  // namespace bimodal::runner
