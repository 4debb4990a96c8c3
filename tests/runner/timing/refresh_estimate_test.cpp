#include "runner/timing/refresh_estimate.hpp"

#include <cstdint>

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

constexpr Instant kPhase{1000ms};
constexpr RefreshEstimate kGrid{.period = 10ms, .phase = kPhase};

TEST(NearestRefresh, TakesTheNearerNeighbourOnBothSidesOfThePhase) {
  EXPECT_EQ(nearest_refresh(kGrid, kPhase), kPhase);
  EXPECT_EQ(nearest_refresh(kGrid, kPhase + 4ms), kPhase);
  EXPECT_EQ(nearest_refresh(kGrid, kPhase + 6ms), kPhase + 10ms);
  EXPECT_EQ(nearest_refresh(kGrid, kPhase - 4ms), kPhase);
  EXPECT_EQ(nearest_refresh(kGrid, kPhase - 6ms), kPhase - 10ms);
  EXPECT_EQ(nearest_refresh(kGrid, kPhase - 104ms), kPhase - 100ms);
}

TEST(NearestRefresh, TakesTheLaterOneHalfWayOnBothSidesOfThePhase) {
  EXPECT_EQ(nearest_refresh(kGrid, kPhase + 5ms), kPhase + 10ms);
  EXPECT_EQ(nearest_refresh(kGrid, kPhase + 5ms - 1ns), kPhase);
  EXPECT_EQ(nearest_refresh(kGrid, kPhase - 5ms), kPhase);
  EXPECT_EQ(nearest_refresh(kGrid, kPhase - 5ms - 1ns), kPhase - 10ms);
  EXPECT_EQ(nearest_refresh(kGrid, kPhase - 15ms), kPhase - 10ms);
  const RefreshEstimate odd{.period = 3ns, .phase = kPhase};
  EXPECT_EQ(nearest_refresh(odd, kPhase + 1ns), kPhase);
  EXPECT_EQ(nearest_refresh(odd, kPhase + 2ns), kPhase + 3ns);
  EXPECT_EQ(nearest_refresh(odd, kPhase - 1ns), kPhase);
  EXPECT_EQ(nearest_refresh(odd, kPhase - 2ns), kPhase - 3ns);
}

TEST(NearestRefresh, LeavesTheInstantWhereThePeriodIsUnknown) {
  EXPECT_EQ(nearest_refresh({}, kPhase + 3ms), kPhase + 3ms);
  EXPECT_EQ(refresh_not_before({}, kPhase + 3ms), kPhase + 3ms);
}

TEST(NearestRefresh, LiesOnTheGridAndAtMostHalfAPeriodAway) {
  Random random{1};
  for (int attempt = 0; attempt < 2000; ++attempt) {
    const RefreshEstimate grid{
        .period = Duration{2 + static_cast<std::int64_t>(2e7 * random.uniform())},
        .phase = Instant{Duration{static_cast<std::int64_t>(1e15 * random.uniform())}}};
    const auto wanted =
        grid.phase + Duration{static_cast<std::int64_t>(4e10 * (random.uniform() - 0.5))};
    const auto refresh = nearest_refresh(grid, wanted);
    EXPECT_EQ((refresh - grid.phase) % grid.period, 0ns);
    EXPECT_LE(2 * (refresh - wanted), grid.period);
    EXPECT_LT(2 * (wanted - refresh), grid.period);
    EXPECT_EQ(nearest_refresh(grid, refresh), refresh);
    const auto not_before = refresh_not_before(grid, wanted);
    EXPECT_EQ((not_before - grid.phase) % grid.period, 0ns);
    EXPECT_GE(not_before, wanted);
    EXPECT_LT(not_before - wanted, grid.period);
  }
}

TEST(RefreshNotBefore, IsTheRefreshItselfOrTheNext) {
  EXPECT_EQ(refresh_not_before(kGrid, kPhase), kPhase);
  EXPECT_EQ(refresh_not_before(kGrid, kPhase + 1ns), kPhase + 10ms);
  EXPECT_EQ(refresh_not_before(kGrid, kPhase - 10ms), kPhase - 10ms);
  EXPECT_EQ(refresh_not_before(kGrid, kPhase - 10ms + 1ns), kPhase);
}

TEST(PeriodOf, RoundsToTheNanosecond) {
  EXPECT_EQ(period_of(Hertz{60}), 16'666'667ns);
  EXPECT_EQ(period_of(Hertz{59.94}), 16'683'350ns);  // 1e9 / 59.94 = 16683350.02
  EXPECT_EQ(period_of(Hertz{1000}), 1ms);
}

}  // namespace
}  // namespace bimodal::runner
