#include "analysis/statistics/interval.hpp"

#include <gtest/gtest.h>

namespace bimodal::analysis {
namespace {

TEST(Wilson, AgreesWithR) {  // R 4.2.2: prop.test(k, n, correct = FALSE)$conf.int
  const auto expect = [](std::int64_t k, std::int64_t n, double low, double high) {
    const auto interval = wilson(k, n).value();
    EXPECT_NEAR(interval.low, low, 1e-11);
    EXPECT_NEAR(interval.high, high, 1e-11);
  };
  expect(0, 10, 0.0, 0.277532799863);
  expect(3, 10, 0.107791267406, 0.603221852539);
  expect(228, 414, 0.502561782541, 0.597954810807);
  expect(414, 414, 0.990806420140, 1.0);
}

TEST(Wilson, OfNothingIsAbsent) {
  EXPECT_EQ(wilson(0, 0), std::nullopt);
}

TEST(Wilson, StaysBetweenZeroAndOneAndHoldsTheProportion) {
  for (std::int64_t n = 1; n < 60; ++n) {
    for (std::int64_t k = 0; k <= n; ++k) {
      const auto interval = wilson(k, n).value();
      const double p = static_cast<double>(k) / static_cast<double>(n);
      EXPECT_GE(interval.low, 0.0);
      EXPECT_LE(interval.low, p);
      EXPECT_GE(interval.high, p);
      EXPECT_LE(interval.high, 1.0);
    }
  }
}

}  // namespace
}  // namespace bimodal::analysis
