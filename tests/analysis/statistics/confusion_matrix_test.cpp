#include "analysis/statistics/confusion_matrix.hpp"

#include <gtest/gtest.h>

namespace bimodal::analysis {
namespace {

ConfusionMatrix example() {  // the syllable /na/ is a label like any other
  ConfusionMatrix matrix{{"MA", "NA", "GA"}, {"MA", "NA", "GA", "blank"}};
  for (int i = 0; i < 3; ++i) matrix.add("MA", "MA");
  matrix.add("MA", "NA");
  matrix.add("NA", "blank");
  matrix.add("NA", "NA");
  return matrix;
}

TEST(ConfusionMatrix, CountsResponsesToEachStimulus) {
  const auto matrix = example();
  EXPECT_EQ(matrix.count(0, 0), 3);
  EXPECT_EQ(matrix.count(1, 3), 1);
  EXPECT_EQ(matrix.row_total(0), 4);
  EXPECT_EQ(matrix.total(), 6);
  EXPECT_EQ(matrix.correct(), 4);
}

TEST(ConfusionMatrix, HasNoProportionWhereAStimulusNeverOccurred) {
  const auto matrix = example();
  EXPECT_EQ(matrix.proportion(0, 0), 0.75);
  EXPECT_EQ(matrix.proportion(2, 0), std::nullopt);
}

TEST(CompareErrors, CorrelatesOffDiagonalRowProportions) {
  ConfusionMatrix one{{"P", "B"}, {"P", "B", "M", "blank"}};
  ConfusionMatrix other = one;
  const auto fill =
      [](ConfusionMatrix& matrix, std::string_view row, const std::vector<int>& counts) {
        for (std::size_t j = 0; j < counts.size(); ++j) {
          for (int k = 0; k < counts[j]; ++k) matrix.add(row, matrix.responses()[j]);
        }
      };
  fill(one, "P", {5, 3, 1, 1});
  fill(one, "B", {4, 4, 2, 0});
  fill(other, "P", {2, 2, 0, 0});
  fill(other, "B", {3, 6, 1, 0});
  // Cells P>B P>M B>P B>M: 3/9 1/9 .4 .2 and .5 0 .3 .1.
  // R: cor(c(3/9,1/9,.4,.2), c(.5,0,.3,.1)) = 0.8284052; sqrt(mean((x-y)^2)) = 0.1226004
  const auto likeness = compare_errors(one, other, {"blank"});
  EXPECT_EQ(likeness.cells, 4U);
  EXPECT_EQ(likeness.cells_used, 4U);
  EXPECT_NEAR(likeness.correlation.value(), 0.8284052, 1e-6);
  EXPECT_NEAR(likeness.rms_deviation.value(), 0.1226004, 1e-6);
}

TEST(CompareErrors, IsAbsentWithoutErrorsOrCommonRows) {
  ConfusionMatrix one{{"P", "B"}, {"P", "B"}};
  ConfusionMatrix other = one;
  EXPECT_EQ(compare_errors(one, other).correlation, std::nullopt);
  EXPECT_EQ(compare_errors(one, other).rms_deviation, std::nullopt);
  one.add("P", "P");
  other.add("P", "P");
  EXPECT_EQ(compare_errors(one, other).cells, 0U);  // nobody met or answered B
  one.add("B", "B");
  other.add("B", "B");
  EXPECT_EQ(compare_errors(one, other).cells, 2U);
  EXPECT_EQ(compare_errors(one, other).correlation, std::nullopt);
  EXPECT_EQ(compare_errors(one, other).rms_deviation, 0.0);
}

TEST(CompareErrors, DoesNotDependOnBlanksOrOnThirdConditions) {
  ConfusionMatrix one{{"P"}, {"P", "B", "M", "blank"}};
  ConfusionMatrix other = one;  // M is answered in neither
  for (int i = 0; i < 2; ++i) {
    one.add("P", "P");
    one.add("P", "B");
  }
  for (const auto* response : {"P", "B", "blank", "blank"}) other.add("P", response);
  EXPECT_EQ(compare_errors(one, other, {"blank"}).cells, 1U);
  EXPECT_EQ(compare_errors(one, other, {"blank"}).rms_deviation, 0.0);
}

}  // namespace
}  // namespace bimodal::analysis
