#include "runner/timing/start_up_gate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr Duration kPeriod{16'666'667};

/// A monitor on its own, `jitter` more and less in turn.
StartUp monitor(Duration jitter = 20us, std::size_t flips = 100) {
  StartUp start_up{.nominal = kPeriod, .is_seen = true, .by_hardware = true};
  for (std::size_t i = 0; i < flips; ++i) {
    start_up.intervals.push_back(kPeriod + (i % 2 == 0 ? jitter : -jitter));
  }
  return start_up;
}

TEST(StartUpGate, CallsASteadyMonitorGood) {
  const auto gate = judge(monitor());
  EXPECT_EQ(gate.verdict, TimingVerdict::Good);
  EXPECT_THAT(gate.reasons, IsEmpty());
  EXPECT_EQ(gate.flips, 100U);
  EXPECT_NEAR(static_cast<double>(gate.deviation.count()), 20'100.8, 1.0);  // 20 us * sqrt(100/99)
  EXPECT_EQ(gate.outliers, 0U);
}

TEST(StartUpGate, CallsAnUnsteadyOneUsableAndSaysWhy) {
  const auto gate = judge(monitor(300us));
  EXPECT_EQ(gate.verdict, TimingVerdict::Usable);
  EXPECT_THAT(gate.reasons, ElementsAre(HasSubstr("0.302 ms")));
}

TEST(StartUpGate, DoesNotCallACompositorsWordGood) {
  auto start_up = monitor();
  start_up.is_composited = true;
  EXPECT_EQ(judge(start_up).verdict, TimingVerdict::Good);  // it has the hardware's
  start_up.by_hardware = false;
  EXPECT_EQ(judge(start_up).verdict, TimingVerdict::Usable);
}

TEST(StartUpGate, ToleratesOneMissedFlipInAHundredForGoodAndFiveForUsable) {
  auto start_up = monitor();
  start_up.intervals[40] = 2 * kPeriod;
  EXPECT_EQ(judge(start_up).verdict, TimingVerdict::Good);
  EXPECT_EQ(judge(start_up).longest, 2 * kPeriod);
  for (const std::size_t at : {50U, 60U, 70U, 80U}) start_up.intervals[at] = 2 * kPeriod;
  EXPECT_EQ(judge(start_up).verdict, TimingVerdict::Usable);
  EXPECT_EQ(judge(start_up).outliers, 5U);
  start_up.intervals[90] = 3 * kPeriod;
  EXPECT_EQ(judge(start_up).verdict, TimingVerdict::NotForTiming);
}

TEST(StartUpGate, RefusesWhatNobodySeesOrTooFewSaw) {
  auto predicted = monitor();
  predicted.is_seen = false;
  EXPECT_EQ(judge(predicted).verdict, TimingVerdict::NotForTiming);
  EXPECT_THAT(judge(predicted).reasons, ElementsAre(HasSubstr("predicted")));
  EXPECT_EQ(judge(monitor(20us, 99)).verdict, TimingVerdict::NotForTiming);
  EXPECT_EQ(judge(StartUp{.is_seen = true}).verdict, TimingVerdict::NotForTiming);
}

TEST(StartUpGate, RefusesJitterAndAnotherRateThanTheModes) {
  EXPECT_EQ(judge(monitor(2'100us)).verdict, TimingVerdict::NotForTiming);
  auto slow = monitor();
  slow.nominal = 10ms;
  EXPECT_THAT(judge(slow).reasons, ElementsAre(HasSubstr("display mode 10.00")));
}

}  // namespace
}  // namespace bimodal::runner
