#include "synth/fitting/lip_timing.hpp"

#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace bimodal::synth {
namespace {

using namespace std::chrono_literals;

/// A measure sampled every `step` ms of one second.
struct Sampled {
  std::vector<double> times;
  std::vector<double> values;

  Sampled(double step, const std::function<double(double)>& measure) {
    for (double time = 0; time <= 1000; time += step) {
      times.push_back(time);
      values.push_back(measure(time));
    }
  }

  [[nodiscard]] Course course() const { return {.time_ms = times, .values = values}; }
};

const TimedPhone kB{.phone = Phone::B, .start = 450ms, .duration = 100ms};
const TimedPhone kUw{.phone = Phone::UW, .start = 450ms, .duration = 100ms};

/// Open by 10 mm, shut at `centre` for about 100 ms.
std::function<double(double)> shutting(double centre) {
  return [centre](double time) {
    return std::min(10.0, std::max(0.0, std::abs(time - centre) / 10 - 5));
  };
}

TEST(Closure, IsInTheMiddleOfTheShutStretch) {
  for (const double centre : {430.0, 470.0, 513.0}) {
    const Sampled often{1, shutting(centre)};
    const auto found = closure(often.course(), kB);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->lowest_mm, 0);
    EXPECT_NEAR(found->time_ms.value(), centre, 0.5);
    const Sampled pictures{40, shutting(centre)};
    EXPECT_NEAR(closure(pictures.course(), kB).value().time_ms.value(), centre, 12);
  }
}

TEST(Closure, HasNoTimeWhereLipsOnlyOpenOrOnlyClose) {
  const auto found = [](const std::function<double(double)>& measure) {
    return closure(Sampled(10, measure).course(), kB).value();
  };
  EXPECT_FALSE(found([](double time) { return time / 100; }).time_ms);
  EXPECT_FALSE(found([](double time) { return 10 - time / 100; }).time_ms);
  EXPECT_FALSE(found([](double) { return 0.0; }).time_ms);
  EXPECT_EQ(found([](double) { return 0.0; }).lowest_mm, 0);
}

TEST(Closure, IsAbsentWhereNothingIsMeasured) {
  const TimedPhone late{.phone = Phone::B, .start = 5s, .duration = 100ms};
  EXPECT_FALSE(closure(Sampled(10, [](double) { return 0.0; }).course(), late));
}

TEST(Rounding, IsHalfWayWhereHalfOfTheFallIsReached) {
  // From 50 mm at 300 ms straight to 44 mm at 500 ms, and back.
  const Sampled course{10,
                       [](double time) { return 44 + std::min(6.0, std::abs(time - 500) * 0.03); }};
  const auto found = rounding(course.course(), kUw, 1.5);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->fall_mm, 6, 1e-9);
  EXPECT_NEAR(found->half_way_ms, 400, 1e-9);
  EXPECT_EQ(found->narrowest_ms, 500);
  EXPECT_FALSE(rounding(course.course(), kUw, 7));
}

TEST(Rounding, IsAbsentWhereTheWidthDoesNotRiseAgain) {
  const Sampled course{10, [](double time) { return 50 - time / 100; }};
  EXPECT_FALSE(rounding(course.course(), kUw, 0.5));
}

TEST(Middle, IsTheMedianWithTheStandardDeviation) {
  EXPECT_EQ(middle_of({}).count, 0);
  EXPECT_EQ(middle_of({3}).median, 3);
  EXPECT_FALSE(middle_of({3}).sd);
  const auto four = middle_of({4, 1, 2, 9});
  EXPECT_EQ(four.median, 3);
  EXPECT_NEAR(four.sd.value(), std::sqrt(38.0 / 3), 1e-12);
}

TEST(Phones, ThatCloseAndRoundLips) {
  EXPECT_TRUE(closes_lips(Phone::M));
  EXPECT_FALSE(closes_lips(Phone::F));
  EXPECT_TRUE(rounds_lips(Phone::W));
  EXPECT_FALSE(rounds_lips(Phone::AO));
}

}  // namespace
}  // namespace bimodal::synth
