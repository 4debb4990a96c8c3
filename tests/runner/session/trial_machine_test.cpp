#include "runner/session/trial_machine.hpp"

#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using Phase = TrialMachine::Phase;

constexpr Instant kStart{};

Keystroke press(Key key, Instant at, std::string text = {}) {
  return {.key = key, .text = std::move(text), .at = at, .source = "poll"};
}

TrialMachine responding(TrialRules rules = {.fixation = 500ms, .time_limit = 2s}) {
  TrialMachine trial{rules};
  static_cast<void>(trial.on(FixationShown{kStart}));
  static_cast<void>(trial.on(StimulusEnded{kStart + 1s}));
  return trial;
}

TEST(TrialMachine, SchedulesTheStimulusFromTheFixationThatWasSeen) {
  TrialMachine trial{{.fixation = 500ms}};
  const auto commands = trial.on(FixationShown{kStart + 16ms});
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_EQ(std::get<StartStimulus>(commands[0]).earliest, kStart + 516ms);
}

TEST(TrialMachine, RecordsTheEditedAnswerAndTheFirstKey) {
  auto trial = responding();
  for (const char* const letter : {"b", "a", "d"}) {
    EXPECT_TRUE(trial.on(press(Key::Text, kStart + 1'300ms, letter)).empty());
  }
  EXPECT_TRUE(trial.on(press(Key::Backspace, kStart + 1'400ms)).empty());
  const auto commands = trial.on(press(Key::Enter, kStart + 1'500ms));
  ASSERT_EQ(commands.size(), 1U);
  const auto& response = std::get<RecordResponse>(commands[0]);
  EXPECT_EQ(response.text, "ba");
  EXPECT_EQ(response.submitted, kStart + 1'500ms);
  EXPECT_EQ(response.first_key, kStart + 1'300ms);
  EXPECT_FALSE(response.timed_out);
  EXPECT_EQ(response.uncertainty, Duration{0});
}

TEST(TrialMachine, IgnoresClicksAndButtonsWhereAnswersAreTyped) {
  auto trial = responding();
  static_cast<void>(trial.on(press(Key::Text, kStart + 1'300ms, "b")));
  auto click = press(Key::Pointer, kStart + 1'350ms);
  click.button = 1;
  EXPECT_TRUE(trial.on(click).empty());
  EXPECT_TRUE(trial.on(press(Key::Button, kStart + 1'400ms)).empty());
  EXPECT_EQ(trial.phase(), Phase::Responding);
  EXPECT_EQ(trial.answer(), "b");
}

TEST(TrialMachine, TakesNoClickForTheFirstKey) {
  auto trial = responding();
  static_cast<void>(trial.on(press(Key::Pointer, kStart + 1'100ms)));
  static_cast<void>(trial.on(press(Key::Text, kStart + 1'300ms, "b")));
  const auto commands = trial.on(press(Key::Enter, kStart + 1'500ms));
  EXPECT_EQ(std::get<RecordResponse>(commands.at(0)).first_key, kStart + 1'300ms);
}

TEST(Keystroke, IsStoredByItsTextItsNameOrItsButtonAndPlace) {
  EXPECT_EQ(label({.key = Key::Text, .text = "é"}), "é");
  EXPECT_EQ(label({.key = Key::Backspace}), "Backspace");
  EXPECT_EQ(label({.key = Key::Pointer, .button = 3, .x = 0.5, .y = 0.25}),
            "Pointer3 0.5000 0.2500");
  EXPECT_EQ(label({.key = Key::Button, .button = 2}), "Button2");
}

TEST(TrialMachine, KeepsTheUncertaintyOfEnter) {
  auto trial = responding();
  static_cast<void>(trial.on(press(Key::Text, kStart + 1'300ms, "b")));
  auto stroke = press(Key::Enter, kStart + 1'500ms);
  stroke.uncertainty = 16ms;
  EXPECT_EQ(std::get<RecordResponse>(trial.on(stroke).at(0)).uncertainty, 16ms);
}

TEST(TrialMachine, AnEmptyAnswerIsAnOmission) {
  auto trial = responding();
  const auto commands = trial.on(press(Key::Enter, kStart + 1'200ms));
  EXPECT_EQ(std::get<RecordResponse>(commands.at(0)).text, "");
  EXPECT_EQ(std::get<RecordResponse>(commands.at(0)).first_key, std::nullopt);
}

TEST(TrialMachine, TimesOutAtTheEndOfTheLimitAndKeepsWhatWasTyped) {
  auto trial = responding();
  static_cast<void>(trial.on(press(Key::Text, kStart + 1'300ms, "b")));
  EXPECT_TRUE(trial.on(Tick{kStart + 3s - 1ns}).empty());
  const auto commands = trial.on(Tick{kStart + 3s});
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_TRUE(std::get<RecordResponse>(commands[0]).timed_out);
  EXPECT_EQ(std::get<RecordResponse>(commands[0]).text, "b");
}

TEST(TrialMachine, WaitsForeverWithoutALimit) {
  auto trial = responding({.fixation = 500ms});
  EXPECT_TRUE(trial.on(Tick{kStart + 24h}).empty());
}

TEST(TrialMachine, IgnoresLettersTypedBeforeTheStimulusEnded) {
  TrialMachine trial{{}};
  static_cast<void>(trial.on(FixationShown{kStart}));
  EXPECT_TRUE(trial.on(press(Key::Text, kStart + 10ms, "b")).empty());
  EXPECT_TRUE(trial.on(press(Key::Enter, kStart + 11ms)).empty());
  static_cast<void>(trial.on(StimulusEnded{kStart + 1s}));
  EXPECT_EQ(trial.answer(), "");
}

TEST(TrialMachine, StopsOnlyAfterConfirmation) {
  auto trial = responding();
  EXPECT_TRUE(trial.on(press(Key::Escape, kStart + 1'100ms)).empty());
  EXPECT_EQ(trial.phase(), Phase::Confirming);
  const auto commands = trial.on(press(Key::Escape, kStart + 1'200ms));
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<StopSession>(commands[0]));
}

TEST(TrialMachine, GoesBackToTheUnfinishedAnswerIfStoppingIsNotConfirmed) {
  auto trial = responding();
  static_cast<void>(trial.on(press(Key::Text, kStart + 1'100ms, "b")));
  static_cast<void>(trial.on(press(Key::Escape, kStart + 1'200ms)));
  static_cast<void>(trial.on(press(Key::Enter, kStart + 1'300ms)));
  EXPECT_EQ(trial.phase(), Phase::Responding);
  EXPECT_EQ(trial.answer(), "b");
}

TEST(TrialMachine, AsksForConfirmationAfterTheStimulusIfEscapeWasPressedDuringIt) {
  TrialMachine trial{{}};
  static_cast<void>(trial.on(FixationShown{kStart}));
  EXPECT_TRUE(trial.on(press(Key::Escape, kStart + 10ms)).empty());
  static_cast<void>(trial.on(StimulusEnded{kStart + 1s}));
  EXPECT_EQ(trial.phase(), Phase::Confirming);
}

}  // namespace
}  // namespace bimodal::runner
