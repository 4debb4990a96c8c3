#include "runner/timing/refresh_meter.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

constexpr Duration kPeriod{16'683'350};  // 59.94 Hz
constexpr Instant kStart{Duration{987'654'321'012'345}};

double microseconds(Duration duration) {
  return std::chrono::duration<double, std::micro>{duration}.count();
}

/// The distance from the true instant of the refresh nearest to `wanted`.
double grid_error(const RefreshEstimate& estimate, Instant wanted) {
  return std::abs(microseconds(nearest_refresh(estimate, wanted) - wanted));
}

TEST(RefreshMeter, KnowsNothingBeforeTwoInstants) {
  RefreshMeter meter;
  EXPECT_EQ(meter.estimate().period, 0ns);
  meter.add(kStart);
  EXPECT_EQ(meter.estimate().period, 0ns);
  EXPECT_EQ(meter.estimate().count, 0);
  meter.add(kStart + 10ms);
  EXPECT_EQ(meter.estimate().period, 10ms);
}

TEST(RefreshMeter, FindsAPerfectGridExactly) {
  RefreshMeter meter;
  for (int k = 0; k <= 1000; ++k) meter.add(kStart + k * kPeriod);
  EXPECT_EQ(meter.estimate().period, kPeriod);
  EXPECT_EQ(meter.estimate().deviation, 0ns);
  EXPECT_EQ(meter.estimate().count, 1000);
  EXPECT_EQ(meter.estimate().phase, kStart + 1000 * kPeriod);
  EXPECT_EQ(meter.counts().irregular, 0);
  EXPECT_EQ(meter.counts().skipped, 0);
}

TEST(RefreshMeter, SeesThroughJitterOfTheStamps) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random{seed};
    RefreshMeter meter;
    for (int k = 0; k <= 100; ++k) {
      meter.add(kStart + k * kPeriod + Duration{std::llround(200'000 * random.uniform())});
    }
    // Uniform jitter over 200 us: SD 57.7 us each; the slope through 101 of them has a standard
    // error of 57.7 * sqrt(12 / 101^3) = 0.2 us; an interval has SD sqrt(2) * 57.7 = 81.6 us.
    EXPECT_NEAR(microseconds(meter.estimate().period), microseconds(kPeriod), 1.0);
    EXPECT_NEAR(microseconds(meter.estimate().deviation), 81.6, 20.0);
    EXPECT_LT(grid_error(meter.estimate(), kStart + 101 * kPeriod + 100us), 100.0);
  }
}

TEST(RefreshMeter, GivesTheDeviationOfSinglePeriods) {
  // Alternately 16 and 17 ms, 50 each: SD with n - 1 is 0.5 * sqrt(100 / 99) = 0.502519 ms.
  RefreshMeter meter;
  auto at = kStart;
  meter.add(at);
  for (int k = 0; k < 100; ++k) meter.add(at += k % 2 == 0 ? 16ms : 17ms);
  EXPECT_EQ(meter.estimate().deviation, Duration{502'519});
}

TEST(RefreshMeter, CountsSkippedRefreshesAndKeepsTheGrid) {
  Random random{3};
  RefreshMeter meter;
  std::int64_t skipped = 0;
  std::int64_t refresh = 0;
  for (int k = 0; k < 600; ++k) {
    const auto steps = random.uniform() < 0.3 ? 2 + static_cast<int>(3 * random.uniform()) : 1;
    if (k > 0) skipped += steps - 1;
    if (k > 0) refresh += steps;
    meter.add(kStart + refresh * kPeriod + Duration{std::llround(50'000 * random.uniform())});
  }
  EXPECT_EQ(meter.counts().skipped, skipped);
  EXPECT_EQ(meter.counts().irregular, 0);
  EXPECT_EQ(meter.counts().intervals, 599);
  EXPECT_NEAR(microseconds(meter.estimate().period), microseconds(kPeriod), 0.2);
  EXPECT_LT(grid_error(meter.estimate(), kStart + refresh * kPeriod + 25us), 25.0);
}

TEST(RefreshMeter, IsNotMovedByLateStamps) {
  // One stamp in twelve comes 3 to 12 ms late, as when the process is not woken in time.
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random{seed};
    RefreshMeter meter;
    std::int64_t late = 0;
    for (int k = 0; k <= 400; ++k) {
      const auto is_late = k > 0 && k < 400 && random.uniform() < 1.0 / 12;
      if (is_late) ++late;
      meter.add(kStart + k * kPeriod +
                (is_late ? 4ms + Duration{std::llround(8e6 * random.uniform())} : 0ns));
    }
    EXPECT_NEAR(microseconds(meter.estimate().period), microseconds(kPeriod), 0.01) << seed;
    EXPECT_LT(grid_error(meter.estimate(), kStart + 401 * kPeriod), 1.0) << seed;
    EXPECT_GE(meter.counts().irregular, late) << seed;
    EXPECT_EQ(meter.counts().restarts, 0) << seed;
  }
}

TEST(RefreshMeter, FollowsAScreenWhosePeriodDrifts) {
  // The period grows by 10 parts in a million each second for a minute.
  RefreshMeter meter;
  double at = 0.0;
  double period = 16'666'667.0;
  for (int k = 0; k < 3600; ++k) {
    meter.add(kStart + Duration{std::llround(at)});
    at += period;
    period *= 1.0 + 1e-5 / 60.0;
  }
  const auto next = kStart + Duration{std::llround(at)};
  EXPECT_LT(grid_error(meter.estimate(), next), 100.0);
  // The fit gives the period of the middle of the last 8.5 s.
  EXPECT_NEAR(microseconds(meter.estimate().period), period / 1000.0, 16'667e-5 * 8.6 / 2 * 1.1);
}

TEST(RefreshMeter, FindsItsPhaseAgainAfterALongPause) {
  Random random{11};
  const auto jitter = [&random] { return Duration{std::llround(100'000 * random.uniform())}; };
  RefreshMeter meter;
  for (int k = 0; k < 200; ++k) meter.add(kStart + k * kPeriod + jitter());
  const auto before = meter.estimate().period;
  const auto resumed = kStart + 10min + 7ms;
  meter.add(resumed + jitter());
  for (int k = 1; k < 20; ++k) meter.add(resumed + k * kPeriod + jitter());
  EXPECT_EQ(meter.estimate().period, before);
  EXPECT_LT(grid_error(meter.estimate(), resumed + 20 * kPeriod + 50us), 50.0);
  for (int k = 20; k < 200; ++k) meter.add(resumed + k * kPeriod + jitter());
  EXPECT_NEAR(microseconds(meter.estimate().period), microseconds(kPeriod), 0.5);
}

TEST(RefreshMeter, FollowsATimerThatLosesTimeAtOnce) {
  RefreshMeter meter;
  auto at = kStart;
  for (int k = 0; k < 400; ++k) meter.add(at += kPeriod);
  meter.add(at += kPeriod + 4ms);
  for (int k = 0; k < 5; ++k) meter.add(at += kPeriod);
  EXPECT_LT(grid_error(meter.estimate(), at + kPeriod), 10.0);
  EXPECT_NEAR(microseconds(meter.estimate().period), microseconds(kPeriod), 1.0);
}

/// How far the next refreshes are predicted off (root of the mean square, in units of the jitter),
/// `ahead` of the last, for a screen that gives `stamp(k)`.
template <typename Stamp>
double prediction_error(int ahead, Duration jitter, Stamp stamp) {
  double squares = 0.0;
  int count = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random{seed};
    RefreshMeter meter;
    std::vector<Instant> instants;
    for (int k = 0; k < 600; ++k) instants.push_back(stamp(k, instants, random));
    for (int k = 0; k + ahead < 600; ++k) {
      meter.add(instants[static_cast<std::size_t>(k)]);
      if (k < 200) continue;
      const auto then = instants[static_cast<std::size_t>(k + ahead)];
      const auto off = nearest_refresh(meter.estimate(), then) - then;
      squares +=
          std::pow(static_cast<double>(off.count()) / static_cast<double>(jitter.count()), 2);
      ++count;
    }
  }
  return std::sqrt(squares / count);
}

/// Uniform, SD 1 times `jitter`.
Duration noise(Duration jitter, Random& random) {
  return Duration{std::llround(static_cast<double>(jitter.count()) * std::sqrt(12.0) *
                               (random.uniform() - 0.5))};
}

TEST(RefreshMeter, FollowsAGridThatWandersByItsLastInstant) {
  // A timer that counts each period from the last refresh: the best prediction two refreshes ahead
  // from the last instant has an error of sqrt(2) times the jitter, and a little more for the
  // period.
  const auto wandering = [](int k, const std::vector<Instant>& before, Random& random) {
    return k == 0 ? kStart : before.back() + kPeriod + noise(100us, random);
  };
  EXPECT_NEAR(prediction_error(2, 100us, wandering), std::sqrt(2.0), 0.15);
}

TEST(RefreshMeter, AveragesNoisyStampsOfAFixedGrid) {
  // The stamp that is predicted is itself noisy: 1 is perfect; trusting the last one gives sqrt(2).
  const auto fixed = [](int k, const std::vector<Instant>&, Random& random) {
    return kStart + k * kPeriod + noise(100us, random);
  };
  EXPECT_LT(prediction_error(2, 100us, fixed), 1.1);
}

TEST(RefreshMeter, FollowsAWanderingGridAlsoWhereRefreshesAreMissed) {
  const auto wandering = [](int k, const std::vector<Instant>& before, Random& random) {
    if (k == 0) return kStart;
    const int steps = random.uniform() < 0.3 ? 2 : 1;
    auto at = before.back();
    for (int i = 0; i < steps; ++i) at += kPeriod + noise(100us, random);
    return at;
  };
  EXPECT_LT(prediction_error(1, 100us, wandering), 1.4);  // sqrt(1.3) is the least
}

TEST(RefreshMeter, MeasuresAnewWhenTheRateChanges) {
  for (const Duration period : {20'000us, 16'949us, 13'333us, 11'765us, 6'944us}) {
    RefreshMeter meter;
    auto at = kStart;
    for (int k = 0; k < 600; ++k) meter.add(at += 16'400us);
    for (int k = 0; k < 120; ++k) meter.add(at += period);
    EXPECT_GE(meter.counts().restarts, 1) << period.count();
    EXPECT_EQ(meter.estimate().period, period);
    EXPECT_EQ(meter.estimate().phase, at);
  }
}

TEST(RefreshMeter, KeepsItsGridWhileTheMachineIsOverloaded) {
  // Of every screen 0 to 4 refreshes are missed, and the stamp of every one comes up to 6 ms late.
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random{seed};
    RefreshMeter meter;
    for (int k = 0; k <= 100; ++k) meter.add(kStart + k * kPeriod);
    std::int64_t refresh = 100;
    for (int k = 0; k < 600; ++k) {
      refresh += 1 + static_cast<std::int64_t>(random.below(5));
      const auto late = random.uniform();
      meter.add(kStart + refresh * kPeriod + Duration{std::llround(6e6 * late * late)});
      ASSERT_NEAR(microseconds(meter.estimate().period), microseconds(kPeriod), 40.0) << seed;
      ASSERT_LT(grid_error(meter.estimate(), kStart + refresh * kPeriod), 6'000.0) << seed;
    }
    EXPECT_EQ(meter.counts().restarts, 0) << seed;
  }
}

TEST(RefreshMeter, RecoversFromAStartUpOnAnOverloadedMachine) {
  // Every second refresh is missed at first, which looks like half the rate.
  RefreshMeter meter;
  auto at = kStart;
  for (int k = 0; k < 40; ++k) meter.add(at += 2 * kPeriod);
  EXPECT_EQ(meter.estimate().period, 2 * kPeriod);
  for (int k = 0; k < 40; ++k) meter.add(at += kPeriod);
  EXPECT_EQ(meter.estimate().period, kPeriod);
}

}  // namespace
}  // namespace bimodal::runner
