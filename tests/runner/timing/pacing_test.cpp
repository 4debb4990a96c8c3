#include "runner/timing/pacing.hpp"

#include <initializer_list>
#include <vector>

#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

constexpr Instant kPhase{1000ms};
constexpr RefreshEstimate kGrid{.period = 16ms, .phase = kPhase};

TEST(PlanRefresh, MeetsADeadlineOnTheGrid) {
  const auto plan = plan_refresh(kGrid, kPhase + 1ms, kPhase + 48ms);
  EXPECT_EQ(plan.target, kPhase + 48ms);
  EXPECT_EQ(plan.submit, kPhase + 34ms);  // 2 ms after the refresh before
}

TEST(PlanRefresh, TakesTheNextRefreshForADeadlineInThePast) {
  EXPECT_EQ(plan_refresh(kGrid, kPhase + 1ms, kPhase - 1h).target, kPhase + 16ms);
  EXPECT_EQ(plan_refresh(kGrid, kPhase + 15ms, kPhase).target, kPhase + 16ms);
}

TEST(PlanRefresh, NeverTakesTheRefreshThatIsNow) {
  EXPECT_EQ(plan_refresh(kGrid, kPhase, kPhase).target, kPhase + 16ms);
  EXPECT_EQ(plan_refresh(kGrid, kPhase - 1ns, kPhase).target, kPhase);
}

TEST(PlanRefresh, WorksBeforeThePhase) {
  EXPECT_EQ(plan_refresh(kGrid, kPhase - 100ms, kPhase - 48ms).target, kPhase - 48ms);
  EXPECT_EQ(plan_refresh(kGrid, kPhase - 100ms, kPhase - 200ms).target, kPhase - 96ms);
}

TEST(PlanRefresh, DoesWithoutAGridWhatItCan) {
  const auto plan = plan_refresh({}, kPhase, kPhase + 5ms);
  EXPECT_EQ(plan.target, kPhase + 5ms);
  EXPECT_EQ(plan.submit, kPhase);
}

/// Every millisecond of now and deadline over some periods, against the definition: the first
/// refresh after now that is not earlier than the deadline less half a period.
TEST(PlanRefresh, IsTheFirstReachableRefreshNotEarlierThanHalfAPeriodBeforeTheDeadline) {
  for (auto now = kPhase - 40ms; now <= kPhase + 40ms; now += 1ms) {
    for (auto deadline = kPhase - 80ms; deadline <= kPhase + 80ms; deadline += 500us) {
      auto expected = kPhase - 160ms;
      while (expected <= now || expected < deadline - 8ms) expected += 16ms;
      const auto plan = plan_refresh(kGrid, now, deadline);
      ASSERT_EQ(plan.target, expected);
      ASSERT_GT(plan.submit, plan.target - kGrid.period);
      ASSERT_LT(plan.submit, plan.target);
    }
  }
}

TEST(PlanRefresh, PresentsEveryRefreshOnceWhenDeadlinesFollowTheGrid) {
  auto now = kPhase + 100us;
  for (int k = 1; k < 1000; ++k) {
    // Deadlines that were computed from a slightly different estimate still meet their refreshes.
    const auto wobble = std::chrono::microseconds{k % 13 - 6} * 500;
    const auto plan = plan_refresh(kGrid, now, kPhase + k * kGrid.period + wobble);
    ASSERT_EQ(plan.target, kPhase + k * kGrid.period);
    now = plan.target + 100us;
  }
}

TEST(OnsetOfSwap, IsTheReturnOfASwapThatWaitedForItsRefresh) {
  const auto plan = plan_refresh(kGrid, kPhase + 1ms, kPhase + 16ms);
  const auto on_time = onset_of_swap(kGrid, plan, kPhase + 16ms + 50us);
  EXPECT_EQ(on_time.onset, kPhase + 16ms + 50us);
  EXPECT_TRUE(on_time.seen);
  EXPECT_TRUE(onset_of_swap(kGrid, plan, kPhase + 12ms).seen);
  const auto missed = onset_of_swap(kGrid, plan, kPhase + 32ms);
  EXPECT_EQ(missed.onset, kPhase + 32ms);
  EXPECT_TRUE(missed.seen);
}

TEST(OnsetOfSwap, IsOnlyPredictedWhenTheSwapCameBackTooEarly) {
  const auto plan = plan_refresh(kGrid, kPhase + 1ms, kPhase + 16ms);
  const auto early = onset_of_swap(kGrid, plan, kPhase + 5ms);
  EXPECT_EQ(early.onset, kPhase + 16ms);
  EXPECT_FALSE(early.seen);
}

TEST(SwapWaits, TellsAScreenFromACopy) {
  const auto loop = [](std::initializer_list<Duration> intervals) {
    return swap_waits(std::vector<Duration>{intervals}, 16'667us);
  };
  EXPECT_TRUE(loop({16'667us, 16'600us, 16'700us, 16'667us}));
  EXPECT_TRUE(loop({30ms, 3'334us, 16'700us, 33'334us}));  // woken late once, a refresh missed
  EXPECT_FALSE(loop({150us, 150us, 160us, 5ms}));          // Xvfb
  EXPECT_FALSE(loop({7ms, 6ms, 40ms, 6ms}));               // the same on a loaded machine
  EXPECT_TRUE(swap_waits(std::vector<Duration>(20, 2'083us), 2'083us));  // 480 Hz
}

}  // namespace
}  // namespace bimodal::runner
