#include "analysis/report/benefits.hpp"

#include <algorithm>

#include <gmock/gmock.h>

#include "tests/analysis/report/planned_study.hpp"

namespace bimodal::analysis {
namespace {

using examples::five_conditions;
using examples::kParticipants;
using examples::results_of;
using testing::IsEmpty;
using testing::SizeIs;

const BenefitRow& row_of(const Results& results, std::string_view bimodal) {
  const auto found = std::ranges::find(results.benefits, bimodal, &BenefitRow::bimodal);
  EXPECT_NE(found, results.benefits.end());
  return *found;
}

// Counts by hand; intervals by numpy: 200,000 draws of the same two multinomials, quantiles of the
// inverted distribution function: gain [.2222, .5694], relative [.4634, .9057].
TEST(Benefits, AreOfEveryBimodalConditionAgainstItsVoiceAlone) {
  const auto results = results_of(five_conditions());
  ASSERT_THAT(results.benefits, SizeIs(3));
  const auto& natural = row_of(results, "AV natural");
  EXPECT_EQ(natural.auditory, "A");
  EXPECT_EQ(natural.visual, "V natural");
  EXPECT_EQ(natural.participants, 6);
  EXPECT_EQ(natural.words, 12);
  EXPECT_EQ(natural.n, 72);
  EXPECT_EQ(natural.n_auditory, 72);
  EXPECT_EQ(natural.n_visual, 72);
  EXPECT_DOUBLE_EQ(natural.a, 31.0 / 72.0);
  EXPECT_DOUBLE_EQ(natural.av, 60.0 / 72.0);
  EXPECT_DOUBLE_EQ(natural.v.value(), 12.0 / 72.0);
  EXPECT_DOUBLE_EQ(natural.benefit.gain, 29.0 / 72.0);
  EXPECT_NEAR(natural.benefit.relative.value(), 29.0 / 41.0, 1e-12);
  ASSERT_TRUE(natural.gain_interval && natural.relative_interval);
  EXPECT_NEAR(natural.gain_interval->low, 0.2222, 0.015);
  EXPECT_NEAR(natural.gain_interval->high, 0.5694, 0.015);
  EXPECT_NEAR(natural.relative_interval->low, 0.4634, 0.02);
  EXPECT_NEAR(natural.relative_interval->high, 0.9057, 0.02);
  EXPECT_EQ(natural.method, "crossed bootstrap, 6 participants x 12 words, 20000 draws");
  EXPECT_TRUE(row_of(results, "AV synthetic").visual.empty());
}

TEST(Benefits, HaveAPointForEveryParticipant) {
  const auto results = results_of(five_conditions());
  const auto& own = row_of(results, "AV synthetic").own;
  ASSERT_THAT(own, SizeIs(6));
  // 5 w mod 7 of w = 0 to 11 is 0 5 3 1 6 4 2 0 5 3 1 6
  EXPECT_EQ(own[0].participant, "P0");
  EXPECT_DOUBLE_EQ(own[0].auditory, 5.0 / 12.0);
  EXPECT_DOUBLE_EQ(own[0].bimodal, 7.0 / 12.0);
}

TEST(Benefits, DrawTheSameParticipantsAndWordsForAllConditions) {
  const auto results = results_of(five_conditions());
  const auto& same = row_of(results, "AV static");  // answered as A was, word by word
  EXPECT_EQ(same.benefit.gain, 0.0);
  EXPECT_FALSE(same.gain_interval);  // no draw has any other gain
}

// By numpy as above: [.1333, .6667].
TEST(Benefits, OfASyntheticFaceAreAShareOfTheNaturalOnes) {
  const auto results = results_of(five_conditions());
  ASSERT_THAT(results.shares, SizeIs(2));  // "face" and "picture" are not of a corpus
  const auto& share = results.shares[0];
  EXPECT_EQ(share.natural, "AV natural");
  EXPECT_EQ(share.synthetic, "AV static");
  EXPECT_NEAR(results.shares[1].share.value(), 10.0 / 29.0, 1e-12);
  ASSERT_TRUE(results.shares[1].interval);
  EXPECT_NEAR(results.shares[1].interval->low, 0.1333, 0.03);
  EXPECT_NEAR(results.shares[1].interval->high, 0.6667, 0.03);
}

TEST(Benefits, TakeForNaturalAndSyntheticWhatWasNamedSo) {
  const auto results = results_of(five_conditions(),
                                  kParticipants,
                                  {.bootstrap = {.draws = 200, .seed = 1},
                                   .faces = FaceConditions{"V natural", "AV synthetic"}});
  ASSERT_THAT(results.shares, SizeIs(1));
  EXPECT_EQ(results.shares[0].natural, "AV natural");
  EXPECT_EQ(results.shares[0].synthetic, "AV synthetic");
}

TEST(Benefits, HaveNoIntervalOfOneParticipant) {
  const auto results = results_of(five_conditions(), 1);
  const auto& row = row_of(results, "AV natural");
  EXPECT_FALSE(row.gain_interval);
  EXPECT_EQ(row.method, "no interval: one participant tells nothing about others");
}

TEST(Benefits, AreNotToldWhereItIsNotClearWhichVoiceAloneIsMeant) {
  auto conditions = five_conditions();
  conditions.push_back(conditions[0]);
  conditions.back().name = "A again";
  EXPECT_THAT(results_of(conditions).benefits, IsEmpty());
}

}  // namespace
}  // namespace bimodal::analysis
