#include "runner/timing/clock_map.hpp"

#include <cmath>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"
#include "tests/runner/realtime/count_allocations.hpp"

namespace bimodal::runner {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Hertz kRate{48'000};
constexpr Duration kSecond = seconds{1};

/// A device whose samples last `period` ns each, sample 0 at 1000 s after the clock's zero.
struct Device {
  double period = 1e9 / 48'000;

  [[nodiscard]] Instant instant(std::int64_t sample) const {
    return Instant{seconds{1000}} + Duration{std::llround(static_cast<double>(sample) * period)};
  }
};

std::vector<ClockPair> readings(const Device& device, std::size_t count, std::int64_t buffer) {
  std::vector<ClockPair> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    const auto sample = static_cast<std::int64_t>(i) * buffer;
    pairs.push_back({sample, device.instant(sample)});
  }
  return pairs;
}

TEST(FitClock, IsAbsentWithoutReadings) {
  EXPECT_FALSE(fit_clock({}, kRate, kSecond).has_value());
}

TEST(FitClock, UsesTheNominalRateForOneReading) {
  const ClockPair pair{480, Instant{seconds{5}}};
  const auto fit = fit_clock({&pair, 1}, kRate, kSecond).value();
  EXPECT_EQ(fit.instant_of(480), Instant{seconds{5}});
  EXPECT_EQ(fit.instant_of(960), Instant{seconds{5} + milliseconds{10}});
  EXPECT_EQ(fit.sample_at(Instant{seconds{6}}), 48'480);
}

TEST(FitClock, FindsTheDriftOfADevice) {
  // a device that is 100 parts in a million fast plays 48 000 samples in 1 / 1.0001 s
  const Device fast{1e9 / 48'000 / 1.0001};
  const auto fit = fit_clock(readings(fast, 1000, 128), kRate, kSecond).value();
  EXPECT_NEAR(fit.drift_ppm, 100.0, 0.01);
  EXPECT_LE(fit.residual, Duration{1});
  EXPECT_EQ(fit.count, 1000U);
  const auto later = 1000 * 128 + 480'000;
  EXPECT_LE(std::abs((fit.instant_of(later) - fast.instant(later)).count()), 20);
  EXPECT_EQ(fit.sample_at(fast.instant(later)), later);
}

TEST(FitClock, AgreesWithRForALine) {
  // R: x <- c(0, 24000, 48000, 96000, 120000)
  //    y <- c(0, 500010000, 1000000000, 2000020000, 2499990000)
  //    f <- lm(y ~ x); coef(f); sigma(f)
  //    -> 5116.2790699, 20833.3139535; 13118.4230478
  const std::vector<ClockPair> pairs{{0, Instant{}},
                                     {24'000, Instant{Duration{500'010'000}}},
                                     {48'000, Instant{Duration{1'000'000'000}}},
                                     {96'000, Instant{Duration{2'000'020'000}}},
                                     {120'000, Instant{Duration{2'499'990'000}}}};
  const auto fit = fit_clock(pairs, kRate, kSecond).value();
  EXPECT_EQ(fit.count, 5U);
  EXPECT_NEAR(fit.nanoseconds_per_sample, 20833.3139535, 1e-6);
  EXPECT_NEAR(static_cast<double>(fit.instant_of(0).time_since_epoch().count()), 5116.279, 1.0);
  EXPECT_NEAR(static_cast<double>(fit.residual.count()), 13118.42, 1.0);
}

TEST(FitClock, IsNotMovedByCallbacksThatWereInterrupted) {
  const Device device;
  Random random{8};
  auto pairs = readings(device, 1000, 128);
  for (auto& pair : pairs) {
    pair.instant += Duration{std::llround(20'000 * random.normal())};
    if (random.below(10) == 0) pair.instant += microseconds{500 + random.below(20'000)};
  }
  const auto fit = fit_clock(pairs, kRate, kSecond).value();
  EXPECT_NEAR(static_cast<double>((fit.instant_of(64'000) - device.instant(64'000)).count()),
              0.0,
              4.0 * 20'000 / std::sqrt(900.0));
  EXPECT_NEAR(static_cast<double>(fit.residual.count()), 20'000, 2'000);
  EXPECT_NEAR(static_cast<double>(fit.rejected), 100, 30);
}

TEST(FitClock, KeepsEveryReadingOfACoarseClock) {
  const Device device;
  auto pairs = readings(device, 1000, 128);
  for (auto& pair : pairs)
    pair.instant = Instant{floor<milliseconds>(pair.instant.time_since_epoch())};
  const auto fit = fit_clock(pairs, kRate, kSecond).value();
  EXPECT_EQ(fit.rejected, 0U);
  // buffers begin 0, 2/3 and 1/3 ms after a whole one in turn, and lose that
  EXPECT_NEAR(static_cast<double>((fit.instant_of(64'000) - device.instant(64'000)).count()),
              -333'333,
              5'000);
}

TEST(FitClock, AssumesTheNominalRateUntilDriftCanShow) {
  Random random{9};
  auto pairs = readings(Device{}, 20, 128);
  for (auto& pair : pairs) pair.instant += Duration{std::llround(50'000 * random.normal())};
  const auto fit = fit_clock(pairs, kRate, kSecond).value();
  EXPECT_EQ(fit.drift_ppm, 0.0);
  EXPECT_NEAR(static_cast<double>((fit.instant_of(48'000) - Device{}.instant(48'000)).count()),
              0.0,
              60'000);
}

TEST(FitClock, SurvivesReadingsOfOneSample) {
  const std::vector<ClockPair> pairs(30, ClockPair{7, Instant{seconds{3}}});
  const auto fit = fit_clock(pairs, kRate, Duration{}).value();
  EXPECT_EQ(fit.instant_of(7), Instant{seconds{3}});
  EXPECT_TRUE(std::isfinite(fit.nanoseconds_per_sample));
}

TEST(ClockMap, MapsThereAndBackForAnyDevice) {
  Random random{10};
  for (int round = 0; round < 50; ++round) {
    const double drift = 1.0 + 400e-6 * (random.uniform() - 0.5);
    const Device device{1e9 / 48'000 / drift};
    ClockMap map{kRate};
    const auto buffer = static_cast<std::int64_t>(32 + random.below(1000));
    std::int64_t sample = 0;
    for (; sample < 5 * 48'000; sample += buffer) {
      map.add({sample, device.instant(sample) + Duration{std::llround(10'000 * random.normal())}});
    }
    const auto fit = map.fit().value();
    const auto ahead = sample + 24'000;
    EXPECT_EQ(fit.sample_at(fit.instant_of(ahead)), ahead);
    EXPECT_LT(std::abs((fit.instant_of(ahead) - device.instant(ahead)).count()), 10'000);
    EXPECT_EQ(map.jumps(), 0);
  }
}

TEST(ClockMap, StartsAnewAfterAnUnderflow) {
  const Device device;
  Random random{11};
  ClockMap map{kRate};
  for (std::int64_t sample = 0; sample < 96'000; sample += 128) {
    const Duration lost = sample < 64'000 ? Duration{} : Duration{5'333'333};  // two buffers
    map.add(
        {sample, device.instant(sample) + lost + Duration{std::llround(20'000 * random.normal())}});
  }
  EXPECT_EQ(map.jumps(), 1);
  EXPECT_EQ(map.latest_jump(), 64'000);
  const auto expected = device.instant(100'000) + Duration{5'333'333};
  EXPECT_LT(std::abs((map.fit()->instant_of(100'000) - expected).count()), 10'000);
}

TEST(ClockMap, DoesNotTakeOneLateCallbackForAJump) {
  const Device device;
  ClockMap map{kRate};
  for (std::int64_t i = 0; i < 500; ++i) {
    const Duration late = i % 50 == 49 ? Duration{milliseconds{30}} : Duration{};
    map.add({i * 128, device.instant(i * 128) + late});
  }
  EXPECT_EQ(map.jumps(), 0);
  EXPECT_FALSE(map.latest_jump());
  EXPECT_LE(std::abs((map.fit()->instant_of(70'000) - device.instant(70'000)).count()), 1000);
}

TEST(ClockMap, ForgetsWhatLiesBeforeAGap) {
  const Device device;
  ClockMap map{kRate};
  for (std::int64_t i = 0; i < 500; ++i) map.add({i * 128, device.instant(i * 128)});
  const auto later = device.instant(64'000) + seconds{60};  // the stream stood still for a while
  map.add({60 * 48'000, later});
  EXPECT_EQ(map.fit()->count, 1U);
  EXPECT_EQ(map.fit()->instant_of(60 * 48'000), later);
  EXPECT_EQ(map.jumps(), 1);
  EXPECT_EQ(map.latest_jump(), 60 * 48'000);
}

TEST(ClockMap, AllocatesNothingHoweverLongItFollows) {
  const Device device;
  ClockMap map{kRate};
  map.add({0, device.instant(0)});
  const auto before = allocations_of_this_thread();
  for (std::int64_t i = 1; i < 5000; ++i) {
    const Duration late = i < 3000 ? Duration{} : Duration{5'333'333};
    map.add({i * 128, device.instant(i * 128) + late});
    if (i % 6 == 0) static_cast<void>(map.fit());
  }
  EXPECT_EQ(allocations_of_this_thread(), before);
  EXPECT_EQ(map.jumps(), 1);
}

}  // namespace
}  // namespace bimodal::runner
