#include "runner/timing/pacing.hpp"

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

TEST(SwapWaits, TellsAScreenFromACopy) {
  EXPECT_FALSE(swap_waits(150us));  // Xvfb
  EXPECT_TRUE(swap_waits(16'667us));
  EXPECT_TRUE(swap_waits(2'083us));  // 480 Hz
}

}  // namespace
}  // namespace bimodal::runner
