#include "analysis/statistics/contrasts.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bimodal::analysis {
namespace {

using testing::AllOf;
using testing::Field;
using testing::SizeIs;

constexpr double kExact = 1e-12;

/// A synthetic face that does not show p from f, and shows p and t as well as the natural one. By
/// hand: phi-square of two rows that were presented equally often is the sum of the columns'
/// (a - b)^2 / (a + b), over the n of both rows: for p and f in the natural face, (14 - 1)^2 / 15 +
/// (4 - 17)^2 / 21, over 40.
TEST(Contrasts, RankAPlantedFailureFirst) {
  const std::vector<std::string> labels{"p", "f", "t"};
  const ConfusionMatrix natural{labels, labels, {14, 4, 2, 1, 17, 2, 0, 1, 19}};
  const ConfusionMatrix synthetic{labels, labels, {9, 9, 2, 9, 9, 2, 0, 1, 19}};
  const auto ranked = rank_contrasts(natural, synthetic);
  ASSERT_THAT(ranked, SizeIs(3));
  EXPECT_THAT(ranked.front(),
              AllOf(Field(&Contrast::stimulus, "p"), Field(&Contrast::counterpart, "f")));
  EXPECT_NEAR(ranked.front().one, std::sqrt((13.0 * 13 / 15 + 13.0 * 13 / 21) / 40.0), kExact);
  EXPECT_NEAR(ranked.front().other, 0.0, kExact);
  EXPECT_NEAR(ranked.front().loss(), ranked.front().one, kExact);
  EXPECT_NEAR(ranked.front().confused_one, (4.0 / 20 + 1.0 / 20) / 2.0, kExact);
  EXPECT_NEAR(ranked.front().confused_other, 9.0 / 20, kExact);
  EXPECT_GE(ranked[1].loss(), ranked[2].loss());
  EXPECT_LT(ranked[1].loss(), 0.2);
}

TEST(Contrasts, AreOfStimuliThatBothPresented) {
  const std::vector<std::string> stimuli{"p", "f", "t"};
  const std::vector<std::string> responses{"p", "f", "t", "blank"};
  const ConfusionMatrix one{stimuli, responses, {5, 0, 0, 1, 0, 5, 0, 0, 0, 0, 0, 0}};
  const ConfusionMatrix other{stimuli, responses, {5, 1, 0, 0, 0, 5, 0, 0, 0, 0, 5, 0}};
  const auto ranked = rank_contrasts(one, other);
  ASSERT_THAT(ranked, SizeIs(1));
  EXPECT_EQ(ranked.front().counterpart, "f");
}

TEST(Contrasts, ShowNoLossOfAFaceAgainstItself) {
  const std::vector<std::string> labels{"p", "f", "t"};
  const ConfusionMatrix same{labels, labels, {14, 4, 2, 1, 17, 2, 0, 1, 19}};
  for (const auto& contrast : rank_contrasts(same, same)) EXPECT_EQ(contrast.loss(), 0.0);
}

}  // namespace
}  // namespace bimodal::analysis
