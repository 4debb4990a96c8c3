#include "analysis/statistics/matrix_sampler.hpp"

#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/statistics/viseme_truth.hpp"

namespace bimodal::analysis {
namespace {

/// Pearson's chi-square of 18,000 responses to each row against the proportions, with 17 degrees of
/// freedom a row: of 306 the expected value is 306, and its standard deviation sqrt(2 x 306)
/// = 24.7.
TEST(MatrixSampler, DrawsTheProportions) {
  constexpr std::int64_t kResponses = 18'000;
  const VisemeTruth truth{0.7};
  Random random{3};
  CellCounts counts;
  truth.sampler(kResponses).draw(random, counts);
  double chi_square = 0.0;
  for (std::size_t cell = 0; cell < counts.size(); ++cell) {
    const double expected = truth.proportions()[cell] * kResponses;
    chi_square += (counts[cell] - expected) * (counts[cell] - expected) / expected;
  }
  EXPECT_NEAR(chi_square, 306.0, 100.0);  // four standard deviations
}

TEST(MatrixSampler, DrawsAsManyToEachRowAsItIsToldAndNothingImpossible) {
  const MatrixSampler sampler{{0.0, 1.0, 0.0, 0.25, 0.0, 0.75, 0.0, 0.0, 0.0}, {5, 400, 0}, 3};
  Random random{4};
  CellCounts counts{7, 7};  // of another draw
  sampler.draw(random, counts);
  ASSERT_EQ(counts.size(), 9U);
  EXPECT_EQ(counts[1], 5);
  EXPECT_EQ(counts[3] + counts[5], 400);
  EXPECT_NEAR(counts[3], 100, 35);  // four standard deviations
  EXPECT_EQ(std::accumulate(counts.begin() + 6, counts.end(), 0), 0);
}

/// By hand. Responses were given 8.5, 2.5, 1.5 and .5 times (and a half). First row: one response
/// of 10 was given once, so .1 is kept back for the columns without, in the ratio 1.5 to .5. Second
/// row: all once, so at most half is kept back. Third: nothing once, so nothing is kept back.
TEST(SmoothedProportions, KeepBackWhatGoodAndTuringDo) {
  const auto found = smoothed_proportions({9, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 2, 0, 0, 0}, 4);
  const std::vector<double> wanted{
      0.81, 0.09, 0.075, 0.025, 0.0, 0.25, 0.25, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
  for (const std::size_t cell : {0U, 1U, 2U, 3U, 5U, 6U, 8U, 9U, 10U, 11U, 12U, 13U}) {
    EXPECT_NEAR(found[cell], wanted[cell], 1e-12) << cell;
  }
  EXPECT_NEAR(found[4] / found[7], 11.5 / 0.5, 1e-9);
  EXPECT_NEAR(found[4] + found[7], 0.5, 1e-12);
}

TEST(SmoothedProportions, OfARowSumToOne) {
  Random random{5};
  CellCounts counts;
  for (const std::int64_t responses : {1, 2, 5, 20, 86}) {
    VisemeTruth{0.7}.sampler(responses).draw(random, counts);
    const auto smoothed = smoothed_proportions(counts, VisemeTruth::kLabels);
    for (std::size_t row = 0; row < smoothed.size(); row += VisemeTruth::kLabels) {
      double sum = 0.0;
      for (std::size_t j = 0; j < VisemeTruth::kLabels; ++j) sum += smoothed[row + j];
      EXPECT_NEAR(sum, 1.0, 1e-12);
    }
  }
}

}  // namespace
}  // namespace bimodal::analysis
