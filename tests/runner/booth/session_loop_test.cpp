#include "runner/booth/session_loop.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/devices/device_error.hpp"
#include "tests/runner/booth/session_fixture.hpp"

namespace bimodal::runner {
namespace {

TEST_F(SessionLoopTest, StoresEveryTrialWithItsAnswer) {
  const auto outcome = run(5);
  EXPECT_TRUE(outcome.complete);
  EXPECT_EQ(outcome.trials, 5);
  EXPECT_EQ(outcome.flagged, 0);
  ASSERT_EQ(store_.trials.size(), 5U);
  for (const auto& trial : store_.trials) {
    EXPECT_EQ(trial.response.text, "stew");
    EXPECT_EQ(trial.keystrokes.size(), 5U);
    EXPECT_GT(trial.response.submitted, trial.stimulus_end);
  }
  EXPECT_EQ(store_.events.size(), 2U);  // the breaks
  EXPECT_EQ(outcome.storing.size(), 5U);
}

/// Notes how long its strokes lay about before they were taken.
class PunctualKeyboard final : public Keyboard {
 public:
  explicit PunctualKeyboard(const Clock& clock) : typist_{clock}, clock_{clock} {}

  std::vector<Keystroke> poll() override {
    auto strokes = typist_.poll();
    for (const auto& stroke : strokes) latest = std::max(latest, clock_.now() - stroke.at);
    return strokes;
  }

  void expect(std::string_view answer, Instant from) override { typist_.expect(answer, from); }

  [[nodiscard]] std::string description() const override { return "punctual"; }

  Duration latest{};

 private:
  SimulatedKeyboard typist_;
  const Clock& clock_;
};

TEST_F(SessionLoopTest, TakesStrokesWithinAMillisecondWhateverTheScreenDoes) {
  protocol_.instructions.clear();
  protocol_.farewell.clear();
  plan_ = plan_of(2);
  PunctualKeyboard keyboard{clock_};
  StoreWriter writer{store_};
  static_cast<void>(run_session(
      {.protocol = protocol_,
       .plan = plan_,
       .booth = {clock_, display_, keyboard, audio_},
       .trials = trials_,
       .store = writer,
       .begin = [](const RefreshEstimate&) { return std::int64_t{7}; },
       .answer = [](const protocols::PlannedTrial& trial) { return trial.word.spelling; }}));
  ASSERT_EQ(store_.trials.size(), 2U);
  EXPECT_LE(keyboard.latest, 1ms);
}

TEST_F(SessionLoopTest, ShowsEveryFrameOnceAndInTime) {
  static_cast<void>(run(1));
  const auto& refreshes = store_.trials.at(0).refreshes;
  ASSERT_EQ(refreshes.frame.size(), 102U);
  for (std::size_t i = 0; i < refreshes.frame.size(); ++i) {
    EXPECT_EQ(refreshes.frame[i], static_cast<std::int64_t>(i));
    EXPECT_EQ(refreshes.shown[i], refreshes.planned[i]);
  }
}

TEST_F(SessionLoopTest, KeepsToThePreparedFramesWhenTheDisplayIsOfAnotherRate) {
  SimulatedDisplay slower{clock_, {.rate = Hertz{57.0}}};
  run_on(slower);
  const auto& refreshes = store_.trials.at(0).refreshes;
  // 102 frames of 1/60 s last 96.9 refreshes of 1/57 s; the lead takes 28 of its 28.5.
  EXPECT_EQ(refreshes.frame.size(), 96U);
  EXPECT_LE(refreshes.frame.back(), 101);
  EXPECT_TRUE(std::ranges::is_sorted(refreshes.frame));
}

TEST_F(SessionLoopTest, ReportsTheOnsetOfTheFrameOfTimeZeroHoweverLittleTheRatesDiffer) {
  SimulatedDisplay faster{clock_, {.rate = Hertz{60.01}}};
  run_on(faster);
  const auto& visual = store_.trials.at(0).onsets.at(0);
  ASSERT_EQ(visual.modality, "visual");
  const Duration error = *visual.reported - visual.planned;
  EXPECT_NEAR(std::chrono::duration<double>(error).count(), 0.0, 1e-6);
}

TEST_F(SessionLoopTest, StatesTheAudioVisualOffsetAsAudioMinusVisual) {
  trials_.av_offset = 80ms;
  static_cast<void>(run(1));
  const auto& onsets = store_.trials.at(0).onsets;
  ASSERT_EQ(onsets.size(), 2U);
  EXPECT_EQ(onsets[0].modality, "visual");
  EXPECT_NEAR(std::chrono::duration<double>(*onsets[1].reported - *onsets[0].reported).count(),
              0.080,
              1e-6);
}

TEST_F(SessionLoopTest, TellsOtherEquipmentWhenTrialsBeginAndWhenTheyAreAnswered) {
  std::vector<Instant> fixations;
  bool was_fixation = false;
  display_.observe([&](const Screen& screen, const Presentation& shown) {
    if (screen.fixation && !was_fixation) fixations.push_back(shown.onset);
    was_fixation = screen.fixation;
  });
  static_cast<void>(run(3));
  ASSERT_EQ(store_.trials.size(), 3U);
  ASSERT_EQ(fixations.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& triggers = store_.trials[i].triggers;
    ASSERT_EQ(triggers.size(), 5U);
    EXPECT_EQ(triggers.front().event, "trial_start");
    EXPECT_EQ(triggers.front().planned, fixations[i].time_since_epoch());
    EXPECT_EQ(triggers.back().event, "response");
    EXPECT_EQ(triggers.back().planned, store_.trials[i].response.submitted);
    EXPECT_TRUE(triggers.back().sent.has_value());
    EXPECT_EQ(line_.signals.at(5 * i).trial, static_cast<int>(i));
    EXPECT_EQ(line_.signals.at(5 * i).condition, "bimodal");
  }
}

TEST_F(SessionLoopTest, TellsNobodyOfAnAnswerThatWasNotGiven) {
  protocol_.response.time_limit = 100ms;
  static_cast<void>(run(1));
  ASSERT_TRUE(store_.trials.at(0).response.timed_out);
  EXPECT_EQ(store_.trials.at(0).triggers.back().event, "stimulus_end");
}

/// Loses its device with the first sound.
class LostAudio final : public AudioOutput {
 public:
  void schedule(const Sound& /*sound*/, Instant /*onset*/) override {}

  void move(Instant /*onset*/) override {}

  void stop() override {}

  [[nodiscard]] Playback playback() override { return {.finished = true, .lost = true}; }

  [[nodiscard]] Duration lead_time() const override { return {}; }

  [[nodiscard]] Hertz rate() const override { return Hertz{48'000}; }

  [[nodiscard]] std::string kind() const override { return "portaudio"; }

  [[nodiscard]] std::string description() const override { return "lost"; }

  [[nodiscard]] std::string_view time_source() const override { return "stream_time"; }
};

TEST_F(SessionLoopTest, StoresNoTrialWhoseSoundWasLost) {
  plan_ = plan_of(2);
  LostAudio lost;
  SimulatedKeyboard typist{clock_};
  StoreWriter writer{store_};
  const SessionParts parts{
      .protocol = protocol_,
      .plan = plan_,
      .booth = {clock_, display_, typist, lost},
      .trials = trials_,
      .store = writer,
      .begin = [](const RefreshEstimate&) { return std::int64_t{7}; },
      .answer = [](const protocols::PlannedTrial&) { return std::string{"stew"}; }};
  EXPECT_THROW(static_cast<void>(run_session(parts)), DeviceError);
  EXPECT_THAT(store_.trials, testing::IsEmpty());
}

TEST_F(SessionLoopTest, DoesNotFlagATrialWithoutFaceForALateFixationMark) {
  trials_.has_face = false;
  int presented = 0;
  display_.observe([&](const Screen& screen, const Presentation&) {
    if (screen.fixation && ++presented == 60) display_.drop_next(3);
  });
  const auto outcome = run(1);
  ASSERT_GT(presented, 60);
  EXPECT_EQ(outcome.flagged, 0);
  EXPECT_THAT(store_.trials.at(0).events, testing::IsEmpty());
}

TEST_F(SessionLoopTest, ShowsTheFixationMarkAtEveryRefreshUntilTheStimulusBegins) {
  std::vector<Instant> refreshes;
  display_.observe([&](const Screen& screen, const Presentation& shown) {
    if (screen.captions.empty() && screen.fixation) refreshes.push_back(shown.onset);
  });
  trials_.has_face = false;  // the mark stays during the sound
  static_cast<void>(run(1));
  ASSERT_GT(refreshes.size(), 100U);
  const Duration period = display_.refresh().period;
  for (std::size_t i = 1; i < refreshes.size(); ++i) {
    ASSERT_LT(refreshes[i] - refreshes[i - 1], 3 * period / 2) << "refresh " << i;
  }
}

TEST_F(SessionLoopTest, StopsAndShowsANeutralScreenWhenDataCannotBeKept) {
  store_.fail_at = 1;
  bool neutral = false;
  display_.observe([&](const Screen& screen, const Presentation&) {
    neutral = screen.captions.empty() && screen.picture == nullptr && !screen.fixation;
  });
  EXPECT_THROW(static_cast<void>(run(3)), StoreError);
  EXPECT_TRUE(neutral);
  EXPECT_EQ(store_.trials.size(), 1U);
}

TEST_F(SessionLoopTest, AsksBeforeItStopsOnAPage) {
  ScriptedKeyboard keyboard{clock_, {Key::Escape, Key::Enter, Key::Escape, Key::Escape}};
  const auto outcome = run(2, &keyboard);
  EXPECT_FALSE(outcome.complete);
  EXPECT_EQ(outcome.session, std::nullopt);
}

TEST_F(SessionLoopTest, DoesNotStoreTheTrialInWhichItWasStopped) {
  ScriptedKeyboard keyboard{clock_, {Key::Enter, Key::Escape, Key::Escape}};
  const auto outcome = run(2, &keyboard);
  EXPECT_FALSE(outcome.complete);
  EXPECT_EQ(outcome.session, 7);
  EXPECT_TRUE(store_.trials.empty());
  ASSERT_EQ(store_.events.size(), 1U);
  EXPECT_EQ(store_.events[0].kind, "stopped");
}

}  // namespace
}  // namespace bimodal::runner
