#include "protocols/observers/phone_table.hpp"

#include <gtest/gtest.h>

#include "protocols/observers/observer_description.hpp"

namespace bimodal::protocols {
namespace {

using enum Phone;

/// Two consonants that are told apart in proportion `right`; everything else is recognised.
PhoneTable between_p_and_b(double right) {
  PhoneTable table = identity_confusions();
  table(P, P) = right;
  table(P, B) = 1.0 - right;
  table(B, B) = right;
  table(B, P) = 1.0 - right;
  return table;
}

ObserverDescription listener() {
  return {.name = "listener",
          .provenance = "test",
          .stated_snr = Decibels{-8},
          .slope_per_db = 0.25,
          .auditory = between_p_and_b(0.8),
          .visual = between_p_and_b(0.6)};
}

void expect_rows_sum_to_one(const PhoneTable& table) {
  for (const Phone phone : all_phones().subspan(1)) {
    EXPECT_NEAR(table.row_sum(phone), 1.0, 1e-12) << symbol(phone);
  }
  EXPECT_EQ(table.row_sum(Rest), 0.0);
}

TEST(FuzzyProduct, MultipliesSupportAndDividesByTheSum) {
  // a = (.8, .2), v = (.6, .4): .48 and .08 of .56
  const auto both = fuzzy_product(between_p_and_b(0.8), between_p_and_b(0.6));
  EXPECT_NEAR(both(P, P), 0.48 / 0.56, 1e-12);
  EXPECT_NEAR(both(P, B), 0.08 / 0.56, 1e-12);
  EXPECT_NEAR(both(B, B), 6.0 / 7.0, 1e-12);
  EXPECT_EQ(both(M, M), 1.0);
}

TEST(FuzzyProduct, TellsNothingNewWhereOneSourceTellsNothing) {
  const auto both = fuzzy_product(between_p_and_b(0.8), uniform_confusions());
  for (const Phone stimulus : all_phones()) {
    for (const Phone response : all_phones()) {
      EXPECT_NEAR(both(stimulus, response), between_p_and_b(0.8)(stimulus, response), 1e-12);
    }
  }
}

TEST(FuzzyProduct, DoesNotCareWhichSourceIsWhich) {
  const auto one = fuzzy_product(between_p_and_b(0.8), between_p_and_b(0.3));
  const auto other = fuzzy_product(between_p_and_b(0.3), between_p_and_b(0.8));
  EXPECT_EQ(one, other);
}

TEST(Confusions, AreTheStatedTableAtTheStatedRatio) {
  const auto table = confusions(listener(), {.heard = true, .seen = false, .snr = Decibels{-8}});
  EXPECT_EQ(table, listener().auditory);
}

TEST(Confusions, ApproachRecognitionAboveAndGuessingBelowTheStatedRatio) {
  // tanh(.25 * 4 / 2) = tanh(.5) = .46211716 (R: tanh(.5)); 25 consonants
  const double w = 0.46211715726000975;
  const auto better = confusions(listener(), {.heard = true, .seen = false, .snr = Decibels{-4}});
  EXPECT_NEAR(better(P, P), (1 - w) * 0.8 + w, 1e-12);
  EXPECT_NEAR(better(P, B), (1 - w) * 0.2, 1e-12);
  const auto worse = confusions(listener(), {.heard = true, .seen = false, .snr = Decibels{-12}});
  EXPECT_NEAR(worse(P, P), (1 - w) * 0.8 + w / 25, 1e-12);
  EXPECT_NEAR(worse(P, M), w / 25, 1e-12);
}

TEST(Confusions, GrowMonotonicallyClearerWithTheRatio) {
  double last = 0.0;
  for (int snr = -40; snr <= 40; ++snr) {
    const auto table = confusions(
        listener(), {.heard = true, .seen = false, .snr = Decibels{static_cast<double>(snr)}});
    expect_rows_sum_to_one(table);
    EXPECT_GE(table(P, P), last) << snr;
    last = table(P, P);
  }
}

TEST(Confusions, WithoutNoiseThereAreNone) {
  EXPECT_EQ(confusions(listener(), {.heard = true, .seen = false, .snr = {}}),
            identity_confusions());
  EXPECT_EQ(confusions(listener(), {.heard = true, .seen = true, .snr = {}}),
            identity_confusions());
}

TEST(Confusions, DoNotDependOnTheRatioWhereNothingIsHeard) {
  EXPECT_EQ(confusions(listener(), {.heard = false, .seen = true, .snr = Decibels{20}}),
            listener().visual);
  EXPECT_EQ(confusions(listener(), {.heard = false, .seen = false, .snr = {}}),
            uniform_confusions());
}

TEST(Confusions, OfBothSensesAreTheFuzzyProduct) {
  const auto table = confusions(listener(), {.heard = true, .seen = true, .snr = Decibels{-8}});
  EXPECT_NEAR(table(P, P), 6.0 / 7.0, 1e-12);
  expect_rows_sum_to_one(table);
}

TEST(ConfusionTables, NeverTurnAConsonantIntoAVowel) {
  EXPECT_EQ(uniform_confusions()(P, IY), 0.0);
  EXPECT_EQ(uniform_confusions()(IY, P), 0.0);
  EXPECT_DOUBLE_EQ(uniform_confusions()(IY, AX), 1.0 / 16.0);
  expect_rows_sum_to_one(uniform_confusions());
  expect_rows_sum_to_one(identity_confusions());
}

}  // namespace
}  // namespace bimodal::protocols
