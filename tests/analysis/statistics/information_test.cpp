#include "analysis/statistics/information.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal::analysis {
namespace {

using testing::ElementsAre;

constexpr double kExact = 1e-12;

/// The third stimulus was never presented, and nobody answered the last label.
ConfusionMatrix example() {
  return {{"p", "b", "-", "m"},
          {"p", "b", "m", "blank", "other"},
          {20, 3, 1, 0, 0, 5, 15, 2, 2, 0, 0, 0, 0, 0, 0, 0, 4, 18, 1, 0}};
}

/// scipy 1.10.1, stats.entropy(..., base=2) of the row sums, the column sums and the cells; the
/// corrections with numpy 1.24.2 from the three corrected entropies.
TEST(Information, IsThatOfScipy) {
  const auto found = information(example()).value();
  EXPECT_EQ(found.responses, 71);
  EXPECT_NEAR(found.stimulus_entropy, 1.5846749360690935, kExact);
  EXPECT_NEAR(found.response_entropy, 1.7666843908440328, kExact);
  EXPECT_NEAR(found.joint_entropy, 2.6502386852168383, kExact);
  EXPECT_NEAR(found.transmitted, 0.7011206416962881, kExact);
  EXPECT_NEAR(found.relative.value(), 0.4424381466116143, kExact);
  EXPECT_NEAR(found.miller_madow, 0.6604813447698383, kExact);
  EXPECT_NEAR(found.all_cells_possible, 0.6401616963066136, kExact);
}

TEST(Information, OfACleanChannelIsAllAndOfANoisyOneNone) {
  const auto clean = information({{"a", "b", "c", "d"},
                                  {"a", "b", "c", "d"},
                                  {7, 0, 0, 0, 0, 7, 0, 0, 0, 0, 7, 0, 0, 0, 0, 7}})
                         .value();
  EXPECT_NEAR(clean.transmitted, 2.0, kExact);
  EXPECT_NEAR(clean.relative.value(), 1.0, kExact);
  const auto noisy = information({{"a", "b"}, {"x", "y", "z"}, {2, 4, 6, 3, 6, 9}}).value();
  EXPECT_NEAR(noisy.transmitted, 0.0, kExact);
  EXPECT_LT(noisy.all_cells_possible, 0.0);
}

TEST(Information, IsAbsentWithoutResponsesAndNotRelativeToASingleStimulus) {
  EXPECT_EQ(information({{"a"}, {"a", "b"}, {0, 0}}), std::nullopt);
  EXPECT_EQ(information({{"a"}, {"a", "b"}, {3, 1}}).value().relative, std::nullopt);
}

ConfusionMatrix random_matrix(Random& random) {
  const auto rows = 1 + random.below(6);
  const auto columns = 1 + random.below(6);
  std::vector<std::string> stimuli;
  std::vector<std::string> responses;
  for (std::size_t i = 0; i < rows; ++i) stimuli.push_back("s" + std::to_string(i));
  for (std::size_t j = 0; j < columns; ++j) responses.push_back("r" + std::to_string(j));
  std::vector<double> counts(rows * columns);
  for (auto& count : counts) count = static_cast<double>(random.below(9)) - 4.0;
  for (auto& count : counts) count = std::max(count, 0.0);
  return {stimuli, responses, counts};
}

TEST(Information, IsNeitherNegativeNorMoreThanEitherEntropyAndGroupsCarryNoMore) {
  Random random{3};
  for (int round = 0; round < 2'000; ++round) {
    const auto matrix = random_matrix(random);
    const auto found = information(matrix);
    if (!found) continue;
    EXPECT_GE(found->transmitted, 0.0);
    EXPECT_LE(found->transmitted,
              std::min(found->stimulus_entropy, found->response_entropy) + 1e-9);
    EXPECT_LE(found->all_cells_possible, found->miller_madow + 1e-9);
    std::vector<std::string> rows;
    std::vector<std::string> columns;
    for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
      rows.push_back(std::to_string(random.below(2)));
    }
    for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
      columns.push_back(std::to_string(random.below(2)));
    }
    const auto coarse = information(grouped(matrix, rows, columns));
    EXPECT_LE(coarse.value().transmitted, found->transmitted + 1e-9);
    EXPECT_EQ(coarse->responses, found->responses);
  }
}

TEST(Information, OfFewResponsesIsTooLargeAndIsCorrectedWhereEveryCellIsPossible) {
  // Four stimuli, each answered right with probability .7 and wrong with .1 each: T = 2 - H(.7, .1,
  // .1, .1) bits.
  const double truth = 2.0 + 0.7 * std::log2(0.7) + 0.3 * std::log2(0.1);
  constexpr int kStudies = 2'000;
  constexpr int kPerStimulus = 100;
  Random random{5};
  double naive = 0.0;
  double corrected = 0.0;
  for (int study = 0; study < kStudies; ++study) {
    ConfusionMatrix matrix{{"a", "b", "c", "d"}, {"a", "b", "c", "d"}};
    for (std::size_t i = 0; i < 4; ++i) {
      std::vector<double> weights(4, 0.1);
      weights[i] = 0.7;
      for (int k = 0; k < kPerStimulus; ++k) {
        matrix.add(matrix.stimuli()[i], matrix.responses()[random.weighted(weights)]);
      }
    }
    const auto found = information(matrix).value();
    naive += found.transmitted / kStudies;
    corrected += found.all_cells_possible / kStudies;
  }
  EXPECT_GT(naive, truth + 0.013);
  EXPECT_NEAR(corrected, truth, 0.003);
}

TEST(Grouped, AddsCountsOfTheSameGroupsAndLeavesOutWhatHasNone) {
  const auto coarse =
      grouped(example(), {"oral", "oral", "oral", "nasal"}, {"oral", "oral", "nasal", "", ""});
  EXPECT_THAT(coarse.stimuli(), ElementsAre("oral", "nasal"));
  EXPECT_THAT(coarse.responses(), ElementsAre("oral", "nasal"));
  EXPECT_EQ(coarse.count(0, 0), 43);
  EXPECT_EQ(coarse.count(0, 1), 3);
  EXPECT_EQ(coarse.count(1, 0), 4);
  EXPECT_EQ(coarse.count(1, 1), 18);
}

}  // namespace
}  // namespace bimodal::analysis
