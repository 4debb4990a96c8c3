#include "runner/timing/stream_times.hpp"

#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

constexpr Hertz kRate{48'000};

/// A host whose "now" is `origin` s at session instant 0 and whose output is 10 ms ahead.
std::vector<CallbackTimes> readings(double origin) {
  std::vector<CallbackTimes> times;
  for (std::int64_t i = 0; i < 64; ++i) {
    const Instant entry{std::chrono::seconds{1000} + Duration{i * 128 * 62'500 / 3}};
    const double now = origin + std::chrono::duration<double>{entry.time_since_epoch()}.count();
    times.push_back({i * 128, entry, now, now + 0.010});
  }
  return times;
}

std::string reason(const std::vector<CallbackTimes>& times) {
  const auto verdict = judge_stream_times(times, kRate);
  return verdict.plausible ? "plausible" : std::string{verdict.reason};
}

TEST(StreamTimes, AreBelievedWhateverTheirOrigin) {
  EXPECT_EQ(reason(readings(0.0)), "plausible");
  EXPECT_EQ(reason(readings(-999.9)), "plausible");
  EXPECT_EQ(reason(readings(1.7e9)), "plausible");
}

TEST(StreamTimes, AreNotBelievedIfZeroOrConstant) {
  auto times = readings(0.0);
  for (auto& t : times) t.output = 0.0;
  EXPECT_EQ(reason(times), "the host gives zero");
  for (auto& t : times) t.output = 5.0;
  EXPECT_EQ(reason(times), "the host gives a constant");
}

TEST(StreamTimes, AreNotBelievedIfNowAndOutputDisagree) {
  auto times = readings(0.0);
  for (auto& t : times) t.current = 0.0;
  EXPECT_EQ(reason(times), "now and output do not share an origin");
  times = readings(0.0);
  for (auto& t : times) t.output -= 0.020;  // heard before it was asked for
  EXPECT_EQ(reason(times), "now and output do not share an origin");
}

TEST(StreamTimes, AreNotBelievedIfTheyDoNotProceedWithTheSessionClock) {
  auto times = readings(0.0);
  for (auto& t : times) {
    t.output = t.current + 0.010 + 0.2 * static_cast<double>(t.sample) / 48'000;
  }
  EXPECT_EQ(reason(times), "stream time does not proceed with the session clock");
  times.at(40).output = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(reason(times), "the host gives no numbers");
}

TEST(StreamTimes, AreBelievedWhenUnderflowsHoldUpTheSamples) {
  auto times = readings(3.0);
  for (std::size_t i = 32; i < times.size(); ++i) {
    times.at(i).entry += std::chrono::milliseconds{80};
    times.at(i).current += 0.080;
    times.at(i).output += 0.080;
  }
  EXPECT_EQ(reason(times), "plausible");
}

TEST(StreamTimes, AreNotBelievedOnTooLittleEvidence) {
  EXPECT_EQ(reason({}), "too few readings");
  auto times = readings(0.0);
  times.resize(15);
  EXPECT_EQ(reason(times), "too few readings");
}

TEST(OutputReading, AddsWhatTheHostIsAheadOrElseItsLatency) {
  const CallbackTimes times{480, Instant{std::chrono::seconds{2}}, 77.5, 77.5125};
  const auto latency = std::chrono::milliseconds{40};
  EXPECT_EQ(output_reading(times, true, latency),
            (ClockPair{480, Instant{std::chrono::microseconds{2'012'500}}}));
  EXPECT_EQ(output_reading(times, false, latency),
            (ClockPair{480, Instant{std::chrono::milliseconds{2'040}}}));
}

TEST(StreamTimes, OfAnInputLieAsFarBeforeAsTheyAreStated) {
  auto times = readings(5.0);
  for (auto& t : times) t.output = t.current - 0.004;
  std::vector<CallbackTimes> ahead;
  for (const auto& t : times) ahead.push_back(mirrored(t));
  EXPECT_EQ(reason(ahead), "plausible");
  const auto pair = input_reading(times[3], true, Duration{});
  EXPECT_EQ(pair.sample, times[3].sample);
  EXPECT_NEAR(static_cast<double>((times[3].entry - pair.instant).count()), 4e6, 10);
  EXPECT_EQ(input_reading(times[3], false, Duration{7}).instant, times[3].entry - Duration{7});
}

}  // namespace
}  // namespace bimodal::runner
