#include "runner/session/cue_sheet.hpp"

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

constexpr Duration kPeriod{16'666'667};

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
  const CueSheet cues{layout(), Hertz{60}, kPeriod, phase, Instant{1s}, Instant{1s}};
  EXPECT_GE(cues.first_refresh(), Instant{1s});
  EXPECT_LT(cues.first_refresh(), Instant{1s + kPeriod});
  EXPECT_EQ((cues.first_refresh() - phase) % kPeriod, 0ns);
}

TEST(CueSheet, LetsSoundAndPictureMeetAtTheRecordingsTimeZero) {
  const CueSheet cues{layout(), Hertz{60}, kPeriod, Instant{}, Instant{1s}, Instant{}};
  EXPECT_EQ(cues.auditory_zero(), cues.visual_zero());
  EXPECT_EQ(cues.sound_onset(), cues.visual_zero() - 500ms);
  EXPECT_EQ(cues.visual_zero(), cues.refresh(30));  // 500 ms later, to the refresh
}

TEST(CueSheet, APositiveOffsetDelaysTheSound) {
  auto offset = layout();
  offset.av_offset = 80ms;
  const CueSheet cues{offset, Hertz{60}, kPeriod, Instant{}, Instant{1s}, Instant{}};
  EXPECT_EQ(cues.auditory_zero() - cues.visual_zero(), 80ms);
}

TEST(CueSheet, WaitsUntilTheSoundCanBeginInTime) {
  auto early_sound = layout();
  early_sound.sound_lead = 2s;
  const CueSheet cues{early_sound, Hertz{60}, kPeriod, Instant{}, Instant{1s}, Instant{1'050ms}};
  EXPECT_GE(cues.sound_onset(), Instant{1'050ms});
  EXPECT_LT(cues.sound_onset(), Instant{1'050ms + kPeriod});
}

TEST(CueSheet, ShowsEveryFrameOnceWhenNothingIsLate) {
  const CueSheet cues{layout(), Hertz{60}, kPeriod, Instant{}, Instant{1s}, Instant{}};
  for (std::int64_t i = 0; i < 102; ++i) EXPECT_EQ(cues.frame_at(i), i);
  EXPECT_EQ(cues.frame_at(102), std::nullopt);
}

TEST(CueSheet, LeavesOutTheFramesWhoseTimeHasPassed) {
  const CueSheet cues{layout(), Hertz{60}, kPeriod, Instant{}, Instant{1s}, Instant{}};
  EXPECT_EQ(cues.refresh_after(10, cues.refresh(10) + 300us), 11);
  EXPECT_EQ(cues.refresh_after(10, cues.refresh(12) - 300us), 13);  // two refreshes missed
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
    const CueSheet cues{any, Hertz{60}, kPeriod, Instant{up_to(16)}, earliest, earliest_sound};
    ASSERT_GE(cues.first_refresh(), earliest);
    ASSERT_GE(cues.sound_onset(), earliest_sound);
    ASSERT_EQ(cues.auditory_zero() - cues.visual_zero(), any.av_offset);
    ASSERT_GE(cues.end(), cues.auditory_zero() + any.recording + any.sound_trail);
    ASSERT_TRUE(cues.frame_at(0).has_value() || any.recording + any.trail == 0ns);
  }
}

}  // namespace
}  // namespace bimodal::runner
