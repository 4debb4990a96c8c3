#include "runner/session/cue_sheet.hpp"

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

constexpr Duration kPeriod{16'666'667};

RefreshEstimate grid(Instant phase = Instant{}, Duration period = kPeriod) {
  return {.period = period, .phase = phase};
}

StimulusLayout layout() {
  return {.recording = 700ms,
          .lead = 500ms,
          .trail = 500ms,
          .sound_lead = 500ms,
          .sound_trail = 500ms,
          .has_sound = true};
}

TEST(CueSheet, CountsTheFramesOfLeadRecordingAndTrail) {
  EXPECT_EQ(lead_frames(layout(), Hertz{60}), 30);
  EXPECT_EQ(frame_count(layout(), Hertz{60}), 30 + 72);
}

TEST(CueSheet, ShowsTheRecordingsTimeZeroWithTheFrameAfterTheLead) {
  EXPECT_EQ(frame_time(layout(), Hertz{60}, 30), 0ns);
  EXPECT_EQ(frame_time(layout(), Hertz{60}, 0), -500ms);
  EXPECT_EQ(frame_time(layout(), Hertz{60}, 33), 50ms);
}

TEST(CueSheet, BeginsOnTheRefreshGridAndNotBeforeItMay) {
  const Instant phase{123'456ns};
  const CueSheet cues{layout(), Hertz{60}, grid(phase), Instant{1s}, Instant{1s}};
  EXPECT_GE(cues.first_refresh(), Instant{1s});
  EXPECT_LT(cues.first_refresh(), Instant{1s + kPeriod});
  EXPECT_EQ((cues.first_refresh() - phase) % kPeriod, 0ns);
}

TEST(CueSheet, LetsSoundAndPictureMeetAtTheRecordingsTimeZero) {
  const CueSheet cues{layout(), Hertz{60}, grid(), Instant{1s}, Instant{}};
  EXPECT_EQ(cues.auditory_zero(), cues.visual_zero());
  EXPECT_EQ(cues.sound_onset(), cues.visual_zero() - 500ms);
  EXPECT_EQ(cues.visual_zero(), cues.first_refresh() + 30 * kPeriod);  // 500 ms, to the refresh
}

TEST(CueSheet, APositiveOffsetDelaysTheSound) {
  auto offset = layout();
  offset.av_offset = 80ms;
  const CueSheet cues{offset, Hertz{60}, grid(), Instant{1s}, Instant{}};
  EXPECT_EQ(cues.auditory_zero() - cues.visual_zero(), 80ms);
}

TEST(CueSheet, WaitsUntilTheSoundCanBeginInTime) {
  auto early_sound = layout();
  early_sound.sound_lead = 2s;
  const CueSheet cues{early_sound, Hertz{60}, grid(), Instant{1s}, Instant{1'050ms}};
  EXPECT_GE(cues.sound_onset(), Instant{1'050ms});
  EXPECT_LT(cues.sound_onset(), Instant{1'050ms + kPeriod});
}

TEST(CueSheet, ShowsEveryFrameOnceWhenNothingIsLate) {
  const CueSheet cues{layout(), Hertz{60}, grid(), Instant{1s}, Instant{}};
  const auto refresh = [&](std::int64_t index) { return cues.first_refresh() + index * kPeriod; };
  EXPECT_EQ(cues.frame_at(refresh(-1)), std::nullopt);
  for (std::int64_t i = 0; i < 102; ++i) EXPECT_EQ(cues.frame_at(refresh(i)), i);
  EXPECT_EQ(cues.frame_at(refresh(102)), std::nullopt);
}

TEST(CueSheet, LeavesOutTheFramesWhoseTimeHasPassed) {
  const CueSheet cues{layout(), Hertz{60}, grid(), Instant{1s}, Instant{}};
  EXPECT_EQ(cues.frame_at(cues.first_refresh() + 10 * kPeriod + 300us), 10);
  EXPECT_EQ(cues.frame_at(cues.first_refresh() + 12 * kPeriod - 300us), 12);
}

TEST(CueSheet, AScreenThatKeepsItsRhythmMovesNothing) {
  CueSheet cues{layout(), Hertz{60}, grid(), Instant{1s}, Instant{}};
  const auto zero = cues.visual_zero();
  cues.follow(grid(Instant{} + 75 * kPeriod));
  EXPECT_EQ(cues.visual_zero(), zero);
  EXPECT_EQ(cues.first_refresh(), zero - 30 * kPeriod);
}

TEST(CueSheet, FollowsAScreenThatWandersWithSoundAndPicture) {
  CueSheet cues{layout(), Hertz{60}, grid(), Instant{1s}, Instant{}};
  const auto planned = cues.visual_zero();
  const auto end = cues.end();
  cues.follow(grid(Instant{} + 75 * kPeriod + 3ms));
  EXPECT_EQ(cues.visual_zero(), planned + 3ms);
  EXPECT_EQ(cues.auditory_zero(), planned + 3ms);
  EXPECT_EQ(cues.end(), end + 3ms);
  EXPECT_EQ(cues.frame_at(planned + 3ms), 30);
}

TEST(CueSheet, FollowsAGrowingPeriodFromRefreshToRefreshWithoutLosingOne) {
  // The period grows by 10 % while 60 refreshes pass: the 30 frames of the lead still take 30.
  Instant shown{1s};
  Duration period = kPeriod;
  auto lead_only = layout();
  CueSheet cues{lead_only, Hertz{60}, grid(shown), shown + 30 * kPeriod, Instant{}};
  int before_zero = 0;
  while (shown + period / 2 < cues.visual_zero()) {
    shown += period;
    period += 28us;
    cues.follow(grid(shown, period));
    if (cues.frame_at(shown)) ++before_zero;
  }
  EXPECT_NEAR(before_zero, 30, 3);
  EXPECT_EQ(cues.visual_zero(), shown);
}

TEST(DrawingRate, IsTheDisplaysNominalRateIfTheMeasuredOneIsNear) {
  EXPECT_EQ(drawing_rate_for(kPeriod), Hertz{60});
  EXPECT_EQ(drawing_rate_for(16'683'350ns), Hertz{60.0 * 1000.0 / 1001.0});
  EXPECT_EQ(drawing_rate_for(16'672'000ns), Hertz{60});
  EXPECT_EQ(drawing_rate_for(16'000'000ns), Hertz{62.5});  // no whole number is near
  EXPECT_EQ(drawing_rate_for(6'944'444ns), Hertz{144});
}

TEST(CueSheetProperty, HoldsItsPromisesForAnyLayout) {
  Random random{5};
  const auto up_to = [&](int ms) {
    return Duration{static_cast<std::int64_t>(random.uniform() * ms * 1e6)};
  };
  for (int round = 0; round < 2'000; ++round) {
    const StimulusLayout any{.recording = up_to(3'000),
                             .lead = up_to(1'000),
                             .trail = up_to(1'000),
                             .sound_lead = up_to(1'500),
                             .sound_trail = up_to(1'000),
                             .av_offset = up_to(1'000) - 500ms,
                             .has_sound = true};
    const Instant earliest{up_to(60'000)};
    const Instant earliest_sound{up_to(60'000)};
    const CueSheet cues{any, Hertz{60}, grid(Instant{up_to(16)}), earliest, earliest_sound};
    ASSERT_GE(cues.first_refresh(), earliest);
    ASSERT_GE(cues.sound_onset(), earliest_sound);
    ASSERT_EQ(cues.auditory_zero() - cues.visual_zero(), any.av_offset);
    ASSERT_GE(cues.end(), cues.auditory_zero() + any.recording + any.sound_trail);
    ASSERT_TRUE(cues.frame_at(cues.first_refresh()).has_value() ||
                any.recording + any.trail == 0ns);
  }
}

}  // namespace
}  // namespace bimodal::runner
