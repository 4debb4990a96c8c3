#include "runner/booth/session_health.hpp"

#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

TEST(SessionHealth, CountsRefreshesThatWereMissedAndFramesThatWereLate) {
  TrialRecord trial;
  trial.refreshes.frame = {0, 1, 3, 4};  // two refreshes passed between frames 1 and 3
  trial.refreshes.planned = {0ms, 10ms, 30ms, 40ms};
  trial.refreshes.shown = {0ms, 10ms, 40ms, 50ms};
  SessionHealth health;
  health.add(trial, 10ms, 3);
  const auto told = health.at(Instant{1s}, {.period = 10ms, .deviation = 1us, .count = 7});
  EXPECT_EQ(told.missed_refreshes, 2);
  EXPECT_EQ(told.late_frames, 2);
  EXPECT_EQ(told.underflows, 3);
  EXPECT_EQ(told.refreshes_measured, 7);
  EXPECT_EQ(told.sound_drift_ppm, std::nullopt);
}

TEST(SessionHealth, TellsTheDriftOfTheLastTrialOnly) {
  TrialRecord trial;
  trial.clock_maps.push_back({.clock = "sound", .drift_ppm = 4.5});
  SessionHealth health;
  health.add(trial, 10ms, 0);
  EXPECT_EQ(health.at({}, {}).sound_drift_ppm, 4.5);
  health.add({}, 10ms, 0);
  EXPECT_EQ(health.at({}, {}).sound_drift_ppm, std::nullopt);
}

TEST(SessionHealth, CountsNothingWithoutADisplay) {
  TrialRecord trial;
  trial.refreshes.planned = {0ms, 10ms};
  trial.refreshes.shown = {0ms, 90ms};
  SessionHealth health;
  health.add(trial, 0ms, 0);
  EXPECT_EQ(health.at({}, {}).missed_refreshes, 0);
  EXPECT_EQ(health.at({}, {}).late_frames, 0);
}

}  // namespace
}  // namespace bimodal::runner
