#include "analysis/statistics/interval.hpp"

#include <cmath>
#include <vector>

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

struct Expected {
  std::int64_t k;
  std::int64_t n;
  double low;
  double high;
};

void expect_intervals(IntervalMethod method, const std::vector<Expected>& expected) {
  for (const auto& one : expected) {
    const auto found = interval_of(method, one.k, one.n).value();
    EXPECT_NEAR(found.low, one.low, 1e-9) << name(method) << ' ' << one.k << ' ' << one.n;
    EXPECT_NEAR(found.high, one.high, 1e-9) << name(method) << ' ' << one.k << ' ' << one.n;
  }
}

/// scipy 1.10.1: stats.beta.ppf.
TEST(Intervals, ByQuantilesOfBetaAreThoseOfScipy) {
  expect_intervals(IntervalMethod::ClopperPearson,
                   {{0, 12, 0.0, 0.26464846939705117},
                    {1, 10, 0.0025285785444617848, 0.4450161170281954},
                    {86, 120, 0.6271794615782887, 0.7951443321364773},
                    {12, 12, 0.7353515306029488, 1.0}});
  expect_intervals(IntervalMethod::Jeffreys,
                   {{0, 12, 0.0, 0.18530593831248504},
                    {7, 12, 0.31194042504011954, 0.8195213052102984},
                    {86, 120, 0.6315935508171375, 0.7914314284736805},
                    {12, 12, 0.8146940616875149, 1.0}});
}

/// scipy 1.10.1: optimize.brentq of |k/n - q| - 1/2n = z sqrt(q (1 - q) / n), that is, without the
/// formula.
TEST(Intervals, WithContinuityCorrectionAreRootsOfTheScoreTest) {
  expect_intervals(IntervalMethod::WilsonCorrected,
                   {{0, 12, 0.0, 0.30125403908221793},
                    {1, 10, 0.005242301569892454, 0.45884601615665616},
                    {7, 12, 0.28599281210392385, 0.835007484869937},
                    {86, 120, 0.6259238586001497, 0.7932864332898932},
                    {12, 12, 0.6987459609177821, 1.0}});
}

/// By hand: n + z^2 = 13.8414588, centre (7 + 1.9207294) / 13.8414588 = .6444934, reach 1.959964
/// sqrt(.6444934 x .3555066 / 13.8414588) = .2521681 for 7 of 10.
TEST(Intervals, OfAgrestiAndCoullStandAroundTheCentreOfWilson) {
  const auto found = interval_of(IntervalMethod::AgrestiCoull, 7, 10).value();
  EXPECT_NEAR(found.low, 0.6444934 - 0.2521681, 1e-6);
  EXPECT_NEAR(found.high, 0.6444934 + 0.2521681, 1e-6);
  const auto centre = wilson(7, 10).value();
  EXPECT_NEAR(found.low + found.high, centre.low + centre.high, 1e-12);
}

TEST(Intervals, AreWiderAtAHigherLevelAndMirrorEachOther) {
  for (const auto method : kIntervalMethods) {
    EXPECT_EQ(interval_of(method, 0, 0), std::nullopt);
    for (std::int64_t n = 1; n < 40; ++n) {
      for (std::int64_t k = 0; k <= n; ++k) {
        const auto found = interval_of(method, k, n).value();
        const auto mirrored = interval_of(method, n - k, n).value();
        EXPECT_NEAR(found.low, 1.0 - mirrored.high, 1e-9);
        const auto wide = interval_of(method, k, n, 0.99).value();
        EXPECT_LE(wide.low, found.low + 1e-12);
        EXPECT_GE(wide.high, found.high - 1e-12);
        EXPECT_GE(found.low, 0.0);
        EXPECT_LE(found.high, 1.0);
      }
    }
  }
}

/// Over all outcomes of 30 trials, each with its probability: exact means never less than 95 %.
TEST(Intervals, CoverAsOftenAsTheirNamesPromise) {
  for (double p = 0.02; p < 0.99; p += 0.03) {
    double exact = 0.0;
    double score = 0.0;
    double outcome = std::pow(1.0 - p, 30.0);
    for (int k = 0; k <= 30; ++k) {
      const auto covers = [&](IntervalMethod method) {
        const auto found = interval_of(method, k, 30).value();
        return found.low <= p && p <= found.high;
      };
      exact += covers(IntervalMethod::ClopperPearson) ? outcome : 0.0;
      score += covers(IntervalMethod::Wilson) ? outcome : 0.0;
      outcome *= (30.0 - k) / (k + 1.0) * p / (1.0 - p);
    }
    EXPECT_GE(exact, 0.95) << p;
    EXPECT_GE(score, 0.83) << p;
  }
}

}  // namespace
}  // namespace bimodal::analysis
