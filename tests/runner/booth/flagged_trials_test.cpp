#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runner/booth/session_fixture.hpp"

namespace bimodal::runner {
namespace {

class FlaggedTrialsTest : public SessionLoopTest {
 protected:
  void begin_anew() {
    trials_.begin_anew();
    store_.trials.clear();
  }
};

TEST_F(FlaggedTrialsTest, FlagsATrialWhoseFramesWereLateAndSaysHowMany) {
  int presented = 0;
  display_.observe([&](const Screen& screen, const Presentation&) {
    if (!screen.captions.empty()) return;
    if (++presented == 40) display_.drop_next(3);
  });
  const auto outcome = run(2);
  EXPECT_EQ(outcome.flagged, 1);
  const auto& trial = store_.trials.at(0);
  EXPECT_TRUE(trial.flagged);
  ASSERT_EQ(trial.events.size(), 1U);
  EXPECT_EQ(trial.events[0].kind, "late_frame");
  EXPECT_EQ(trial.refreshes.frame.size(), 99U);  // three left out rather than shown late
}

/// Time passes after the `number`th frame of the first film, in which nothing is shown.
void stall_after(VirtualClock& clock, SimulatedDisplay& display, int number, Duration time) {
  display.observe(
      [&clock, number, time, frames = -1](const Screen& screen, const Presentation&) mutable {
        if (screen.fixation) frames = std::max(frames, 0);
        const bool is_frame = frames >= 0 && screen.captions.empty() && !screen.fixation;
        if (is_frame && ++frames == number) clock.advance_by(time);
      });
}

std::vector<std::string> kinds(const TrialRecord& trial) {
  std::vector<std::string> all;
  for (const auto& event : trial.events) all.push_back(event.kind);
  return all;
}

TEST_F(FlaggedTrialsTest, FlagsATrialTheEndOfWhoseFilmWasNotShown) {
  stall_after(clock_, display_, 100, 40ms);
  static_cast<void>(run(1));
  const auto& trial = store_.trials.at(0);
  EXPECT_EQ(trial.refreshes.frame.back(), 99);
  EXPECT_THAT(kinds(trial), testing::ElementsAre("late_frame"));
  EXPECT_EQ(trial.events.at(0).detail, "2 refreshes were late");
}

TEST_F(FlaggedTrialsTest, FlagsATrialTheBeginningOfWhoseFilmWasNotShown) {
  int fixations = 0;
  display_.observe(
      [&](const Screen& screen, const Presentation&) { fixations += screen.fixation; });
  static_cast<void>(run(1));
  ASSERT_EQ(store_.trials.at(0).refreshes.frame.front(), 0);
  begin_anew();
  display_.observe([&, seen = 0](const Screen& screen, const Presentation&) mutable {
    if (screen.fixation && ++seen == fixations) clock_.advance_by(45ms);
  });
  static_cast<void>(run(1));
  const auto& trial = store_.trials.at(0);
  EXPECT_GT(trial.refreshes.frame.front(), 0);
  EXPECT_THAT(kinds(trial), testing::Contains("late_frame"));
}

TEST_F(FlaggedTrialsTest, FlagsATrialWhoseTimeZeroWasNotShown) {
  stall_after(clock_, display_, 5, 3s);
  static_cast<void>(run(1));
  const auto& trial = store_.trials.at(0);
  EXPECT_FALSE(trial.onsets.at(0).reported);
  EXPECT_THAT(kinds(trial), testing::IsSupersetOf({"visual_unreported", "late_frame"}));
}

TEST_F(FlaggedTrialsTest, HandsTheSoundOverInTimeThoughItsDeviceIsSlow) {
  reference_.sound_after = 40ms;
  trials_.av_offset = -100ms;  // the sound comes first
  EXPECT_EQ(run(2).flagged, 0);
}

/// Makes three frames late in the trials of these places, counted from 0 as they are presented.
void make_late(SimulatedDisplay& display, std::set<int> trials) {
  display.observe([&display, trials = std::move(trials), trial = -1, frames = 0](
                      const Screen& screen, const Presentation&) mutable {
    if (!screen.captions.empty()) frames = 0;
    if (!screen.captions.empty() || ++frames != 80) return;
    if (trials.contains(++trial)) display.drop_next(3);
  });
}

std::vector<int> numbers(const std::vector<TrialRecord>& trials) {
  std::vector<int> all;
  for (const auto& trial : trials) all.push_back(trial.trial);
  return all;
}

TEST_F(FlaggedTrialsTest, ExcludesFlaggedTrialsOnlyIfTheProtocolSaysSo) {
  for (const auto rule : {protocols::Flagged::Keep, protocols::Flagged::Exclude}) {
    protocol_.timing.flagged = rule;
    store_.trials.clear();
    trials_.begin_anew();
    make_late(display_, {1});
    static_cast<void>(run(3));
    ASSERT_EQ(store_.trials.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(store_.trials[i].flagged, i == 1);
      EXPECT_EQ(store_.trials[i].excluded, i == 1 && rule == protocols::Flagged::Exclude);
    }
  }
}

TEST_F(FlaggedTrialsTest, PresentsFlaggedTrialsAgainAtTheEndOfTheirBlock) {
  protocol_.timing.flagged = protocols::Flagged::Repeat;
  make_late(display_, {0, 1, 2, 6});  // of 0 1 | 0 1 0 | 2 3 | 4 | 4 in this order
  const auto outcome = run(5);
  EXPECT_TRUE(outcome.complete);
  EXPECT_EQ(outcome.trials, 5);
  EXPECT_EQ(outcome.repeated, 4);
  EXPECT_EQ(outcome.flagged, 4);
  EXPECT_THAT(numbers(store_.trials), testing::ElementsAre(0, 1, 5, 6, 7, 2, 3, 8, 4));
  ASSERT_EQ(store_.more.size(), 4U);
  const std::vector<int> originals{0, 1, 0, 3};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(store_.more[i].trial, static_cast<int>(5 + i));
    EXPECT_EQ(store_.more[i].repeats, originals[i]);
  }
  EXPECT_TRUE(store_.trials[2].excluded);
  EXPECT_FALSE(store_.trials[4].excluded);
  EXPECT_EQ(store_.events.size(), 2U);  // the breaks, each after its block's repetitions
}

TEST_F(FlaggedTrialsTest, RepeatsATrialAsOftenAsTheProtocolAllows) {
  protocol_.timing.flagged = protocols::Flagged::Repeat;
  protocol_.timing.most_repeats = 2;
  make_late(display_, {0, 1, 2, 3, 4, 5});
  const auto outcome = run(1);
  EXPECT_TRUE(outcome.complete);
  EXPECT_EQ(outcome.repeated, 2);
  EXPECT_THAT(numbers(store_.trials), testing::ElementsAre(0, 1, 2));
  EXPECT_TRUE(std::ranges::all_of(store_.trials, &TrialRecord::excluded));
}

TEST_F(FlaggedTrialsTest, RepeatsTheVerySameSoundAndSaysSo) {
  protocol_.timing.flagged = protocols::Flagged::Repeat;
  make_late(display_, {0});
  static_cast<void>(run(1));
  ASSERT_EQ(store_.trials.size(), 2U);
  EXPECT_EQ(trials_.given(), 1U);
  EXPECT_EQ(line_.signals.back().trial, 1);
  EXPECT_THAT(told_,
              testing::ElementsAre("trial 1 of 1: bimodal",
                                   "trial 1 is flagged: late_frame (3 refreshes were late)",
                                   "trial 1 again, its timing was not as planned: bimodal"));
}

TEST_F(FlaggedTrialsTest, IsNotCompleteIfARepetitionIsMissing) {
  protocol_.timing.flagged = protocols::Flagged::Repeat;
  make_late(display_, {0});
  ScriptedKeyboard keyboard{clock_, {Key::Enter, Key::Enter, Key::Escape, Key::Escape}};
  const auto outcome = run(1, &keyboard);
  EXPECT_EQ(outcome.trials, 1);
  EXPECT_EQ(outcome.repeated, 0);
  EXPECT_FALSE(outcome.complete);
}

TEST_F(FlaggedTrialsTest, TellsTheOnsetOfTimeZeroAlsoIfItsFrameWasLeftOut) {
  int frames = 0;
  display_.observe([&](const Screen& screen, const Presentation&) {
    if (screen.captions.empty() && !screen.fixation && ++frames == 29) display_.drop_next(1);
  });
  static_cast<void>(run(1));
  const auto& trial = store_.trials.at(0);
  ASSERT_EQ(std::ranges::count(trial.refreshes.frame, 30), 0);
  ASSERT_EQ(std::ranges::count(trial.refreshes.frame, 31), 1);
  const Duration error = *trial.onsets.at(0).reported - trial.onsets.at(0).planned;
  EXPECT_LT(std::chrono::abs(error), 1us);
  EXPECT_TRUE(trial.flagged);
}

/// Is heard a millisecond and a half late.
class TardyAudio final : public AudioOutput {
 public:
  explicit TardyAudio(const Clock& clock) : audio_{clock, Hertz{48'000}} {}

  void schedule(const Sound& sound, Instant onset) override { audio_.schedule(sound, onset); }

  void move(Instant onset) override { audio_.move(onset); }

  void stop() override { audio_.stop(); }

  [[nodiscard]] Playback playback() override {
    auto playback = audio_.playback();
    if (playback.onset) *playback.onset += 1500us;
    return playback;
  }

  [[nodiscard]] Duration lead_time() const override { return audio_.lead_time(); }

  [[nodiscard]] Hertz rate() const override { return audio_.rate(); }

  [[nodiscard]] std::string kind() const override { return "tardy"; }

  [[nodiscard]] std::string description() const override { return "tardy"; }

  [[nodiscard]] std::string_view time_source() const override { return "stream_time"; }

 private:
  SimulatedAudio audio_;
};

TEST_F(FlaggedTrialsTest, FlagsAnOffsetBeyondTheToleranceOfTheProtocol) {
  for (const Duration tolerance : {1ms, 2ms}) {
    trials_.offset_tolerance = tolerance;
    trials_.begin_anew();
    store_.trials.clear();
    TardyAudio tardy{clock_};
    static_cast<void>(run(1, nullptr, &tardy));
    EXPECT_EQ(store_.trials.at(0).flagged, tolerance == 1ms);
  }
}

TEST_F(FlaggedTrialsTest, CountsReactionTimeFromTheOnsetThatTheProtocolNames) {
  trials_.av_offset = 80ms;
  const std::vector<std::pair<protocols::RtFrom, std::string>> cases{
      {protocols::RtFrom::End, "end"},
      {protocols::RtFrom::SoundOnset, "sound_onset"},
      {protocols::RtFrom::VisualOnset, "visual_onset"}};
  for (const auto& [from, name] : cases) {
    protocol_.response.rt_from = from;
    trials_.begin_anew();
    store_.trials.clear();
    TardyAudio tardy{clock_};
    static_cast<void>(run(1, nullptr, &tardy));
    const auto& trial = store_.trials.at(0);
    EXPECT_EQ(trial.response.reference, name);
    const auto seen = *trial.onsets.at(0).reported;
    const auto heard = *trial.onsets.at(1).reported;
    ASSERT_NEAR(std::chrono::duration<double>(heard - seen).count(), 0.0815, 1e-6);
    EXPECT_EQ(trial.response.reference_at,
              from == protocols::RtFrom::End          ? trial.stimulus_end
              : from == protocols::RtFrom::SoundOnset ? heard
                                                      : seen);
  }
}

}  // namespace
}  // namespace bimodal::runner
