#include "analysis/statistics/benefit.hpp"

#include <gtest/gtest.h>

namespace bimodal::analysis {
namespace {

constexpr double kExact = 1e-12;

/// The pilot's proportions, A .55, V .04, AV .72, by hand: gain .17; .17 / .45; (.72 - .04) / .96;
/// ln(.72/.28) - ln(.55/.45) = ln(2.5714286 / 1.2222222); A + V - A V = .568.
TEST(Benefit, IsThatWorkedOutByHand) {
  const auto found = benefit(0.72, 0.55, 0.04);
  EXPECT_NEAR(found.gain, 0.17, kExact);
  EXPECT_NEAR(found.relative.value(), 0.37777777777778, 1e-13);  // .378 in the reference
  EXPECT_NEAR(found.auditory_relative.value(), 0.70833333333333, 1e-13);
  EXPECT_NEAR(found.log_odds.value(), 0.7437909134, 1e-9);
  EXPECT_NEAR(found.excess.value(), 0.152, kExact);  // as in the reference
}

/// Sumby & Pollack's formula makes unlike gains alike: at A = .2 a gain of .4 is half of what could
/// be gained, at A = .8 one of .1.
TEST(Benefit, IsRelativeToWhatCouldBeGained) {
  EXPECT_NEAR(benefit(0.6, 0.2, std::nullopt).relative.value(), 0.5, kExact);
  EXPECT_NEAR(benefit(0.9, 0.8, std::nullopt).relative.value(), 0.5, kExact);
  EXPECT_NEAR(benefit(0.1, 0.2, std::nullopt).relative.value(), -0.125, kExact);
}

TEST(Benefit, IsAbsentWhereItIsNotDefined) {
  const auto perfect = benefit(1.0, 1.0, 1.0);
  EXPECT_EQ(perfect.gain, 0.0);
  EXPECT_FALSE(perfect.relative);
  EXPECT_FALSE(perfect.auditory_relative);
  EXPECT_FALSE(perfect.log_odds);
  EXPECT_FALSE(benefit(0.5, 0.0, 0.1).log_odds);
  EXPECT_FALSE(benefit(1.0, 0.5, 0.1).log_odds);
  const auto without_visual = benefit(0.7, 0.5, std::nullopt);
  EXPECT_FALSE(without_visual.excess);
  EXPECT_FALSE(without_visual.auditory_relative);
}

TEST(Benefit, OfTwoIndependentChancesHasNoExcess) {
  EXPECT_NEAR(benefit(1.0 - 0.7 * 0.6, 0.3, 0.4).excess.value(), 0.0, kExact);
}

/// (.65 - .55) / (.72 - .55).
TEST(ShareOfNaturalBenefit, IsThePartThatTheSyntheticFaceGives) {
  EXPECT_NEAR(share_of_natural_benefit(0.65, 0.72, 0.55).value(), 10.0 / 17.0, kExact);
  EXPECT_NEAR(share_of_natural_benefit(0.72, 0.72, 0.55).value(), 1.0, kExact);
  EXPECT_NEAR(share_of_natural_benefit(0.5, 0.72, 0.55).value(), -5.0 / 17.0, kExact);
  EXPECT_NEAR(share_of_natural_benefit(0.3, 0.4, 0.0).value(), 0.75, kExact);  // of faces alone
  EXPECT_FALSE(share_of_natural_benefit(0.6, 0.55, 0.55));
  EXPECT_FALSE(share_of_natural_benefit(0.6, 0.5, 0.55));
}

}  // namespace
}  // namespace bimodal::analysis
