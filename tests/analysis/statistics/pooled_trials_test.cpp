// Why pooled trials are not taken for independent, and sparse matrices not tested by G: what the
// usual methods would say of simulated data, beside what ours do.

#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/statistics/condition_permutation.hpp"
#include "analysis/statistics/crossed_bootstrap.hpp"
#include "analysis/statistics/interval.hpp"
#include "analysis/statistics/matrix_comparison.hpp"
#include "tests/analysis/statistics/viseme_truth.hpp"

namespace bimodal::analysis {
namespace {

constexpr std::uint32_t kParticipants = 20;
constexpr std::uint32_t kWords = 414;

double logistic(double x) {
  return 1.0 / (1.0 + std::exp(-x));
}

/// How unlike participants and words are: standard deviations on the logit scale.
struct Variety {
  double participants = 0.0;
  double words = 0.0;
};

constexpr double kMeanLogit = 0.5;

/// By quadrature over the sum of both.
double true_proportion(const Variety& variety) {
  const double deviation = std::hypot(variety.participants, variety.words);
  double sum = 0.0;
  double weights = 0.0;
  for (int step = -600; step <= 600; ++step) {
    const double z = step / 100.0;
    const double weight = std::exp(-z * z / 2.0);
    sum += weight * logistic(kMeanLogit + deviation * z);
    weights += weight;
  }
  return sum / weights;
}

std::vector<CrossedCell> simulate(const Variety& variety, Random& random) {
  std::vector<double> words(kWords);
  for (auto& word : words) word = variety.words * random.normal();
  std::vector<CrossedCell> cells;
  for (std::uint32_t p = 0; p < kParticipants; ++p) {
    const double participant = variety.participants * random.normal();
    for (std::uint32_t w = 0; w < kWords; ++w) {
      const bool correct = random.uniform() < logistic(kMeanLogit + participant + words[w]);
      cells.push_back({.participant = p, .word = w, .successes = correct ? 1U : 0U, .trials = 1});
    }
  }
  return cells;
}

/// Of 200 studies, how many intervals of 95 % cover the truth.
struct Covering {
  int bootstrap = 0;
  int wilson = 0;
};

Covering cover(const Variety& variety) {
  const double truth = true_proportion(variety);
  const CrossedBootstrap bootstrap{kParticipants, kWords, {.draws = 200, .seed = 2}};
  Random random{31};
  Covering covering;
  for (int i = 0; i < 200; ++i) {
    const auto cells = simulate(variety, random);
    std::int64_t correct = 0;
    for (const auto& cell : cells) correct += cell.successes;
    const auto holds = [&](const Interval& interval) {
      return interval.low <= truth && truth <= interval.high ? 1 : 0;
    };
    covering.bootstrap += holds(bootstrap.interval(cells).value());
    covering.wilson += holds(wilson(correct, std::ssize(cells)).value());
  }
  testing::Test::RecordProperty("bootstrap", covering.bootstrap);
  testing::Test::RecordProperty("wilson", covering.wilson);
  return covering;
}

/// Participants and words that differ little leave Wilson's interval of 95 % 51 to 84 % of
/// coverage.
TEST(PooledTrials, AreNotIndependentIfParticipantsAndWordsDifferALittle) {
  const auto found = cover({.participants = 0.15, .words = 0.5});
  EXPECT_GE(found.bootstrap, 180);
  EXPECT_GE(found.wilson, 102);
  EXPECT_LE(found.wilson, 168);
}

TEST(PooledTrials, AreNotIndependentIfTheyDifferMuch) {
  const auto found = cover({.participants = 1.0, .words = 1.0});
  EXPECT_GE(found.bootstrap, 180);
  EXPECT_LE(found.wilson, 60);
}

/// One response of each of 20 participants to each of 18 stimuli with either face, which are alike.
std::vector<ComparedTrial> alike_faces(Random& random) {
  const auto sampler = VisemeTruth{0.85}.sampler(1);
  std::vector<ComparedTrial> trials;
  CellCounts counts;
  for (std::uint32_t participant = 0; participant < kParticipants; ++participant) {
    for (const bool other : {false, true}) {
      sampler.draw(random, counts);
      for (std::uint32_t cell = 0; cell < counts.size(); ++cell) {
        if (counts[cell] == 0) continue;
        const auto stimulus = cell / static_cast<std::uint32_t>(VisemeTruth::kLabels);
        trials.push_back({.participant = participant,
                          .item = stimulus,
                          .other = other,
                          .correct = cell % VisemeTruth::kLabels == stimulus,
                          .cells = {cell}});
      }
    }
  }
  return trials;
}

ConfusionMatrix matrix_of(const std::vector<ComparedTrial>& trials, bool other) {
  CellCounts counts(VisemeTruth::kLabels * VisemeTruth::kLabels, 0);
  for (const auto& trial : trials) {
    if (trial.other == other) ++counts[trial.cells.front()];
  }
  return VisemeTruth::matrix_of(counts);
}

/// At .05, of studies of two faces that are alike: G calls most different, the chi-square fewer
/// than it should, the permutation about as many as it should.
TEST(SparseMatrices, AreNotTestedByG) {
  constexpr int kStudies = 200;
  Random random{32};
  int g = 0;
  int chi_square = 0;
  int permutation = 0;
  for (int i = 0; i < kStudies; ++i) {
    const auto trials = alike_faces(random);
    const auto found = compare_matrices(matrix_of(trials, false), matrix_of(trials, true));
    const boost::math::chi_squared distribution{static_cast<double>(found.degrees)};
    g += boost::math::cdf(boost::math::complement(distribution, found.g)) <= 0.05 ? 1 : 0;
    chi_square += found.chi_square_p.value() <= 0.05 ? 1 : 0;
    const auto permuted = permute_conditions(
        trials, VisemeTruth::kLabels, VisemeTruth::kLabels, 199, static_cast<Seed>(i));
    permutation += permuted.p.value() <= 0.05 ? 1 : 0;
  }
  RecordProperty("g", g);
  RecordProperty("chi_square", chi_square);
  RecordProperty("permutation", permutation);
  EXPECT_GE(g, kStudies / 2);
  EXPECT_LE(chi_square, kStudies / 20);
  EXPECT_LE(permutation, 20);  // 10 expected, standard deviation 3.1
}

}  // namespace
}  // namespace bimodal::analysis
