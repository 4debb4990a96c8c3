#include "analysis/statistics/crossed_bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

namespace bimodal::analysis {
namespace {

std::vector<CrossedCell> table(const std::vector<std::vector<std::uint32_t>>& successes) {
  std::vector<CrossedCell> cells;
  for (std::uint32_t p = 0; p < successes.size(); ++p) {
    for (std::uint32_t w = 0; w < successes[p].size(); ++w) {
      cells.push_back({.participant = p, .word = w, .successes = successes[p][w], .trials = 1});
    }
  }
  return cells;
}

TEST(CrossedBootstrap, DrawsEveryResampleAsOftenAsEnumerationSays) {
  // Participants {1 1; 0 1}: both drawn as (2,0), (1,1), (0,2) with probabilities 1/4, 1/2, 1/4,
  // and so are words. Of the nine products: p = 1 for participant 1 alone (1/4) or word 2 alone
  // with anyone else (3/4 x 1/4); 3/4 for both and both (1/4); 1/2 for participant 2 alone with
  // both words (1/8) or both with word 1 alone (1/8); 0 for participant 2 with word 1 (1/16).
  const int draws = 40'000;
  const CrossedBootstrap bootstrap{2, 2, {.draws = draws, .seed = 5}};
  std::map<double, double> share;
  for (const double p : bootstrap.replicates(table({{1, 1}, {0, 1}}))) share[p] += 1.0 / draws;
  ASSERT_EQ(share.size(), 4U);
  EXPECT_NEAR(share[1.0], 7.0 / 16, 0.01);
  EXPECT_NEAR(share[0.75], 4.0 / 16, 0.01);
  EXPECT_NEAR(share[0.5], 4.0 / 16, 0.01);
  EXPECT_NEAR(share[0.0], 1.0 / 16, 0.01);
}

TEST(CrossedBootstrap, TakesOrderStatisticsForItsInterval) {
  // 1/16 of the replicates are 0, so 2.5 % and 97.5 % fall on 0 and 1; 10 % and 90 % on .5 and 1.
  const CrossedBootstrap bootstrap{2, 2, {.draws = 4000, .seed = 5}};
  const auto cells = table({{1, 1}, {0, 1}});
  EXPECT_EQ(bootstrap.interval(cells), (Interval{0.0, 1.0}));
  EXPECT_EQ(bootstrap.interval(cells, 0.8), (Interval{0.5, 1.0}));
  auto replicates = bootstrap.replicates(cells);
  std::ranges::sort(replicates);
  EXPECT_EQ(bootstrap.interval(cells)->low, replicates[99]);  // ceil(.025 x 4000) = 100th
}

TEST(CrossedBootstrap, WeighsCellsByTheirTrials) {
  const CrossedBootstrap bootstrap{1, 1, {.draws = 3, .seed = 1}};
  const std::vector<CrossedCell> cells{{.participant = 0, .word = 0, .successes = 2, .trials = 3}};
  for (const double p : bootstrap.replicates(cells)) EXPECT_DOUBLE_EQ(p, 2.0 / 3.0);
}

TEST(CrossedBootstrap, IsTheSameForTheSameSeed) {
  const auto cells = table({{1, 0, 1}, {0, 1, 1}, {1, 1, 0}});
  const CrossedBootstrap one{3, 3, {.draws = 200, .seed = 7}};
  const CrossedBootstrap same{3, 3, {.draws = 200, .seed = 7}};
  const CrossedBootstrap other{3, 3, {.draws = 200, .seed = 8}};
  EXPECT_EQ(one.replicates(cells), same.replicates(cells));
  EXPECT_NE(one.replicates(cells), other.replicates(cells));
}

TEST(CrossedBootstrap, HasNothingToSayWithoutVariationOrData) {
  const CrossedBootstrap bootstrap{2, 2, {.draws = 100, .seed = 1}};
  EXPECT_EQ(bootstrap.interval(table({{1, 1}, {1, 1}})), std::nullopt);
  EXPECT_EQ(bootstrap.interval(table({{0, 0}, {0, 0}})), std::nullopt);
  EXPECT_EQ(bootstrap.interval({}), std::nullopt);
  const CrossedBootstrap none{0, 0, {.draws = 100, .seed = 1}};
  EXPECT_EQ(none.interval({}), std::nullopt);
}

TEST(CrossedBootstrap, IsAbsentWhereManyDrawsMeetNoTrial) {
  const CrossedBootstrap bootstrap{2, 2, {.draws = 400, .seed = 1}};
  const std::vector<CrossedCell> diagonal{
      {.participant = 0, .word = 0, .successes = 1, .trials = 1},
      {.participant = 1, .word = 1, .successes = 0, .trials = 1}};
  EXPECT_EQ(bootstrap.interval(diagonal), std::nullopt);
}

/// Share of intervals that hold the true proportion, in experiments like ours: participants and
/// words both differ (standard deviations .6 and 1.2 on the logit scale), each word in one of three
/// conditions per participant.
struct Coverage {
  double bootstrap = 0.0;
  double wilson = 0.0;
};

double logistic(double x) {
  return 1.0 / (1.0 + std::exp(-x));
}

double true_proportion(double mean) {  // by quadrature over the sum of both effects
  const double deviation = std::hypot(0.6, 1.2);
  double sum = 0.0;
  double weights = 0.0;
  for (int step = -600; step <= 600; ++step) {
    const double z = step / 100.0;
    const double weight = std::exp(-z * z / 2.0);
    sum += weight * logistic(mean + deviation * z);
    weights += weight;
  }
  return sum / weights;
}

Coverage simulate(int experiments, std::uint32_t participants, std::uint32_t words, double mean) {
  Random random{99};
  const double truth = true_proportion(mean);
  const CrossedBootstrap bootstrap{participants, words, {.draws = 400, .seed = 3}};
  Coverage coverage;
  for (int i = 0; i < experiments; ++i) {
    std::vector<double> word_effects(words);
    for (auto& effect : word_effects) effect = 1.2 * random.normal();
    std::vector<CrossedCell> cells;
    std::int64_t successes = 0;
    for (std::uint32_t p = 0; p < participants; ++p) {
      const double participant_effect = 0.6 * random.normal();
      for (std::uint32_t w = 0; w < words; ++w) {
        if ((p + w) % 3 != 0) continue;
        const bool correct =
            random.uniform() < logistic(mean + participant_effect + word_effects[w]);
        cells.push_back({.participant = p, .word = w, .successes = correct ? 1U : 0U, .trials = 1});
        successes += correct ? 1 : 0;
      }
    }
    const auto holds = [&](const Interval& interval) {
      return interval.low <= truth && truth <= interval.high ? 1.0 / experiments : 0.0;
    };
    coverage.bootstrap += holds(bootstrap.interval(cells).value());
    coverage.wilson += holds(wilson(successes, static_cast<std::int64_t>(cells.size())).value());
  }
  return coverage;
}

TEST(CrossedBootstrap, HoldsTheTruthAboutAsOftenAsItSays) {
  const auto coverage = simulate(300, 20, 60, 0.2);
  RecordProperty("coverage_bootstrap", std::to_string(coverage.bootstrap));
  RecordProperty("coverage_wilson", std::to_string(coverage.wilson));
  EXPECT_GE(coverage.bootstrap, 0.92);
  EXPECT_LE(coverage.wilson, 0.85);  // why trials are not resampled
}

}  // namespace
}  // namespace bimodal::analysis
