#include "runner/timing/moments.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

TEST(Moments, AreThoseWorkedByHand) {
  // 1, 2, 4, 9 ms: mean 4, squares 9 + 4 + 0 + 25 = 38, SD sqrt(38 / 3) = 3.559026.
  const std::vector<Duration> durations{4ms, 1ms, 9ms, 2ms};
  const auto moments = moments_of(durations);
  EXPECT_EQ(moments.count, 4U);
  EXPECT_DOUBLE_EQ(moments.mean_ms, 4.0);
  EXPECT_NEAR(moments.deviation_ms, 3.559026, 1e-6);
  EXPECT_DOUBLE_EQ(moments.median_ms, 3.0);
  EXPECT_DOUBLE_EQ(moments.smallest_ms, 1.0);
  EXPECT_DOUBLE_EQ(moments.largest_ms, 9.0);
  EXPECT_DOUBLE_EQ(moments_of(std::vector<Duration>{-7ms, 2ms}).largest_magnitude_ms, 7.0);
}

TEST(Moments, OfNothingOrOneAreZeroOrWithoutSpread) {
  EXPECT_EQ(moments_of({}).count, 0U);
  const std::vector<Duration> one{5ms};
  EXPECT_DOUBLE_EQ(moments_of(one).mean_ms, 5.0);
  EXPECT_DOUBLE_EQ(moments_of(one).deviation_ms, 0.0);
}

TEST(Histogram, HasBinsAtMultiplesOfARoundWidth) {
  const std::vector<Duration> durations{-1'500us, -200us, 0ms, 100us, 1'900us};
  const auto histogram = histogram_of(durations, 4);
  EXPECT_DOUBLE_EQ(histogram.width_ms, 1.0);
  ASSERT_EQ(histogram.bins.size(), 4U);
  EXPECT_DOUBLE_EQ(histogram.bins[0].from_ms, -2.0);
  EXPECT_EQ(histogram.bins[0].count, 1U);
  EXPECT_EQ(histogram.bins[1].count, 1U);
  EXPECT_EQ(histogram.bins[2].count, 2U);
  EXPECT_EQ(histogram.bins[3].count, 1U);
}

TEST(Histogram, CountsEverythingOnceInAtMostAsManyBinsAsAsked) {
  Random random{9};
  for (int round = 0; round < 500; ++round) {
    std::vector<Duration> durations(1 + random.below(200));
    const double scale = std::pow(10.0, 3.0 + 6.0 * random.uniform());
    for (auto& duration : durations) {
      duration = Duration{static_cast<std::int64_t>(scale * (random.uniform() - 0.3))};
    }
    const auto most = 2 + random.below(30);
    const auto histogram = histogram_of(durations, most);
    std::size_t total = 0;
    for (const auto& bin : histogram.bins) total += bin.count;
    ASSERT_EQ(total, durations.size());
    ASSERT_LE(histogram.bins.size(), most);
  }
}

TEST(Histogram, IsDrawnAsLinesOfText) {
  const std::vector<Duration> durations{100us, 600us, 700us};
  EXPECT_EQ(draw(histogram_of(durations, 2), 4),
            "     +0.0 ms |##   1\n"
            "     +0.5 ms |#### 2\n");
  EXPECT_EQ(draw({}), "");
}

}  // namespace
}  // namespace bimodal::runner
