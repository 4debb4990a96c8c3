// Trials that are answered by choosing one of a few options.

#include "runner/session/choice.hpp"

#include <gtest/gtest.h>

#include "runner/session/trial_machine.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using Phase = TrialMachine::Phase;

constexpr Instant kStart{};
constexpr Instant kOnset = kStart + 1s;
constexpr Instant kEnd = kStart + 2s;

ChoiceRules rules() {
  return {.options = {{.label = "ba", .key = "b", .button = 1}, {.label = "wa", .key = "W"}},
          .boxes = {{0.25, 0.5, 0.2, 0.2}, {0.75, 0.5, 0.2, 0.2}},
          .confirm = false};
}

Keystroke key(std::string text, Instant at) {
  return {.key = Key::Text, .text = std::move(text), .at = at, .uncertainty = 2ms};
}

Keystroke enter(Instant at) {
  return {.key = Key::Enter, .at = at, .uncertainty = 2ms};
}

Keystroke click(double x, Instant at, int button = 1) {
  return {.key = Key::Pointer, .at = at, .button = button, .x = x, .y = 0.5};
}

Keystroke escape(Instant at) {
  return {.key = Key::Escape, .at = at};
}

TrialMachine presenting(TrialRules trial = {.choice = rules()}) {
  TrialMachine machine{std::move(trial)};
  static_cast<void>(machine.on(FixationShown{kStart}));
  static_cast<void>(machine.on(OnsetPassed{kOnset}));
  return machine;
}

TrialMachine responding(TrialRules trial = {.choice = rules()}) {
  auto machine = presenting(std::move(trial));
  EXPECT_TRUE(machine.on(StimulusEnded{kEnd}).empty());
  return machine;
}

const RecordResponse& response(const std::vector<TrialCommand>& commands) {
  return std::get<RecordResponse>(commands.at(0));
}

TEST(Choice, IsByKeyInAnyCaseByButtonOrByClick) {
  const auto options = rules();
  EXPECT_EQ(option_of(options, key("B", kEnd)), 0U);
  EXPECT_EQ(option_of(options, key("w", kEnd)), 1U);
  EXPECT_EQ(option_of(options, key("x", kEnd)), std::nullopt);
  EXPECT_EQ(option_of(options, {.key = Key::Button, .button = 1}), 0U);
  EXPECT_EQ(option_of(options, {.key = Key::Button, .button = 2}), std::nullopt);
  EXPECT_EQ(option_of(options, click(0.75, kEnd)), 1U);
  EXPECT_EQ(option_of(options, click(0.75, kEnd, 3)), std::nullopt);
  EXPECT_EQ(option_of(options, click(0.5, kEnd)), std::nullopt);
}

TEST(Choice, HasAStrokeForEveryOption) {
  auto options = rules();
  options.options.push_back({.label = "da", .button = 4});
  options.options.push_back({.label = "ga"});
  options.boxes.push_back({0.25, 0.8, 0.1, 0.1});
  options.boxes.push_back({0.75, 0.8, 0.1, 0.1});
  for (std::size_t i = 0; i < options.options.size(); ++i) {
    EXPECT_EQ(option_of(options, stroke_for(options, i)), i);
  }
}

TEST(ChoiceTrial, EndsWithTheFirstChoiceAndKeepsItsStamp) {
  auto trial = responding();
  EXPECT_TRUE(trial.on(key("x", kEnd + 100ms)).empty());
  EXPECT_TRUE(trial.on(enter(kEnd + 150ms)).empty());
  EXPECT_TRUE(trial.on(click(0.5, kEnd + 200ms)).empty());
  const auto commands = trial.on(key("w", kEnd + 300ms));
  EXPECT_EQ(response(commands).text, "wa");
  EXPECT_EQ(response(commands).submitted, kEnd + 300ms);
  EXPECT_EQ(response(commands).first_key, kEnd + 300ms);
  EXPECT_EQ(response(commands).uncertainty, 2ms);
  EXPECT_EQ(trial.phase(), Phase::Finished);
}

TEST(ChoiceTrial, TakesNothingThatWasPressedBeforeTheEndAndIsNoticedAfterIt) {
  auto trial = responding();
  EXPECT_TRUE(trial.on(key("b", kEnd - 1ns)).empty());
  EXPECT_EQ(response(trial.on(key("w", kEnd))).text, "wa");
}

TEST(ChoiceTrial, MayBeChangedUntilEnterIfItIsToBeConfirmed) {
  auto options = rules();
  options.confirm = true;
  auto trial = responding({.choice = options});
  EXPECT_TRUE(trial.on(enter(kEnd + 50ms)).empty());
  EXPECT_TRUE(trial.on(key("b", kEnd + 100ms)).empty());
  EXPECT_EQ(trial.chosen(), 0U);
  EXPECT_TRUE(trial.on(click(0.75, kEnd + 200ms)).empty());
  EXPECT_EQ(trial.chosen(), 1U);
  const auto commands = trial.on(enter(kEnd + 300ms));
  EXPECT_EQ(response(commands).text, "wa");
  EXPECT_EQ(response(commands).submitted, kEnd + 300ms);
  EXPECT_EQ(response(commands).first_key, kEnd + 100ms);
}

TEST(ChoiceTrial, IsAnOmissionWhereTheTimeRunsOutAndKeepsWhatWasNotConfirmed) {
  auto options = rules();
  options.confirm = true;
  for (const bool chosen : {false, true}) {
    auto trial = responding({.time_limit = 1s, .choice = options});
    if (chosen) static_cast<void>(trial.on(key("b", kEnd + 100ms)));
    EXPECT_TRUE(trial.on(Tick{kEnd + 1s - 1ns}).empty());
    const auto commands = trial.on(Tick{kEnd + 1s});
    EXPECT_TRUE(response(commands).timed_out);
    EXPECT_EQ(response(commands).text, chosen ? "ba" : "");
    EXPECT_EQ(response(commands).uncertainty, std::nullopt);
  }
}

TEST(ChoiceTrial, TakesNothingDuringTheStimulusUnlessAnswersCountFromTheOnset) {
  auto trial = presenting();
  EXPECT_FALSE(trial.takes_answer());
  EXPECT_TRUE(trial.on(key("b", kOnset + 100ms)).empty());
  EXPECT_TRUE(trial.on(StimulusEnded{kEnd}).empty());
  EXPECT_EQ(trial.phase(), Phase::Responding);
}

TEST(EarlyChoice, IsRecordedWhenTheStimulusHasEnded) {
  auto trial = presenting({.choice = rules(), .from_onset = true});
  EXPECT_TRUE(trial.takes_answer());
  const auto noted = trial.on(key("b", kOnset + 100ms));
  ASSERT_EQ(noted.size(), 1U);
  EXPECT_EQ(std::get<NoteEarlyAnswer>(noted[0]).at, kOnset + 100ms);
  EXPECT_FALSE(trial.takes_answer());
  EXPECT_TRUE(trial.answered_early());
  EXPECT_TRUE(trial.on(key("w", kOnset + 200ms)).empty());
  const auto commands = trial.on(StimulusEnded{kEnd});
  EXPECT_EQ(response(commands).text, "ba");
  EXPECT_EQ(response(commands).submitted, kOnset + 100ms);
  EXPECT_EQ(response(commands).uncertainty, 2ms);
  EXPECT_EQ(trial.phase(), Phase::Finished);
}

TEST(EarlyChoice, CountsFromTheOnsetByItsStamp) {
  auto trial = presenting({.choice = rules(), .from_onset = true});
  EXPECT_TRUE(trial.on(key("b", kOnset - 1ns)).empty());
  EXPECT_FALSE(trial.on(key("w", kOnset)).empty());
}

TEST(EarlyChoice, IsNotBeforeTheOnset) {
  TrialMachine trial{{.choice = rules(), .from_onset = true}};
  static_cast<void>(trial.on(FixationShown{kStart}));
  EXPECT_FALSE(trial.takes_answer());
  EXPECT_TRUE(trial.on(key("b", kOnset)).empty());
}

TEST(EarlyChoice, IsNotByClickForThereIsNothingToClick) {
  auto trial = presenting({.choice = rules(), .from_onset = true});
  EXPECT_TRUE(trial.on(click(0.75, kOnset + 100ms)).empty());
  static_cast<void>(trial.on(StimulusEnded{kEnd}));
  EXPECT_EQ(response(trial.on(click(0.75, kEnd + 100ms))).text, "wa");
}

TEST(EarlyChoice, MayBeConfirmedAfterTheStimulus) {
  auto options = rules();
  options.confirm = true;
  auto trial = presenting({.choice = options, .from_onset = true});
  EXPECT_TRUE(trial.on(key("b", kOnset + 100ms)).empty());
  EXPECT_TRUE(trial.on(StimulusEnded{kEnd}).empty());
  EXPECT_EQ(trial.chosen(), 0U);
  EXPECT_EQ(response(trial.on(enter(kEnd + 100ms))).first_key, kOnset + 100ms);
}

TEST(EarlyChoice, WaitsForTheQuestionWhetherToStop) {
  auto trial = presenting({.choice = rules(), .from_onset = true});
  static_cast<void>(trial.on(key("b", kOnset + 100ms)));
  static_cast<void>(trial.on(escape(kOnset + 200ms)));
  EXPECT_TRUE(trial.on(StimulusEnded{kEnd}).empty());
  EXPECT_EQ(trial.phase(), Phase::Confirming);
  EXPECT_EQ(response(trial.on(enter(kEnd + 1s))).text, "ba");
}

}  // namespace
}  // namespace bimodal::runner
