#include "runner/monitor/remaining_time.hpp"

#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

TEST(RemainingTime, IsNotEstimatedBeforeThreeTrials) {
  RemainingTime time;
  EXPECT_EQ(time.left(10), std::nullopt);
  time.add(5s);
  time.add(5s);
  EXPECT_EQ(time.left(10), std::nullopt);
  time.add(5s);
  EXPECT_EQ(time.left(10), 50s);
}

TEST(RemainingTime, IsNoneWhenNoTrialIsToCome) {
  RemainingTime time;
  for (int i = 0; i < 3; ++i) time.add(5s);
  EXPECT_EQ(time.left(0), 0s);
}

TEST(RemainingTime, IsHardlyChangedByOneTrialThatTookVeryLong) {
  RemainingTime time;
  for (int i = 0; i < 4; ++i) time.add(5s);
  time.add(10min);
  EXPECT_EQ(time.typical_trial(), 5s);
}

TEST(RemainingTime, LiesBetweenTheMiddleTwoOfAnEvenNumber) {
  RemainingTime time;
  for (const auto trial : {4s, 1s, 2s, 9s}) time.add(trial);
  EXPECT_EQ(time.typical_trial(), 3s);
}

TEST(RemainingTime, FollowsTheLatestTwentyTrials) {
  RemainingTime time;
  for (int i = 0; i < 100; ++i) time.add(9s);
  for (int i = 0; i < 10; ++i) time.add(3s);
  EXPECT_EQ(time.typical_trial(), 6s);
  time.add(3s);
  EXPECT_EQ(time.typical_trial(), 3s);
}

}  // namespace
}  // namespace bimodal::runner
