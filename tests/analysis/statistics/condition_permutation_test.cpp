#include "analysis/statistics/condition_permutation.hpp"

#include <cmath>
#include <functional>
#include <set>

#include <gmock/gmock.h>

#include "stimuli/base/random.hpp"

namespace bimodal::analysis {
namespace {

constexpr std::size_t kLabels = 4;

ComparedTrial answered(std::uint32_t participant,
                       std::uint32_t item,
                       bool other,
                       std::uint32_t stimulus,
                       std::uint32_t response) {
  return {.participant = participant,
          .item = item,
          .other = other,
          .correct = stimulus == response,
          .cells = {static_cast<std::uint32_t>(stimulus * kLabels + response)}};
}

TEST(ConditionPermutation, AgreesWithEnumerationOfAllExchanges) {
  // Six pairs (participant x item), stimulus 0, answered 0 with the natural face and 1 with the
  // synthetic, but for one pair that is the other way round. Of the 2^6 = 64 equally likely
  // exchanges the statistic depends on the number k of pairs that show 0 with the natural face,
  // k ~ Binomial(6, 1/2): as large as k = 5 are k = 0, 1, 5, 6, which are (1 + 6 + 6 + 1) / 64.
  std::vector<ComparedTrial> trials;
  for (std::uint32_t pair = 0; pair < 6; ++pair) {
    const std::uint32_t natural = pair == 0 ? 1 : 0;
    trials.push_back(answered(pair % 2, pair, false, 0, natural));
    trials.push_back(answered(pair % 2, pair, true, 0, 1 - natural));
  }
  const auto found = permute_conditions(trials, kLabels, kLabels, 20'000, 1);
  EXPECT_EQ(found.randomisation, Randomisation::WithinItems);
  EXPECT_EQ(found.used, 12);
  EXPECT_NEAR(found.log10_arrangements, std::log10(64.0), 1e-9);
  // 5:1 against 1:5. E = 3 each: 4 (2^2 / 3)
  EXPECT_NEAR(found.chi_square, 16.0 / 3.0, 1e-12);
  ASSERT_TRUE(found.p && found.cell_p[0]);
  EXPECT_NEAR(*found.p, 14.0 / 64.0, 0.012);  // four standard errors
  EXPECT_NEAR(*found.cell_p[0], 14.0 / 64.0, 0.012);
  EXPECT_NEAR(*found.accuracy_p, 14.0 / 64.0, 0.012);
  EXPECT_NEAR(found.accuracy_difference, -4.0 / 6.0, 1e-12);
  EXPECT_FALSE(found.cell_p[2]) << "nobody gave that response";
}

TEST(ConditionPermutation, ExchangesParticipantsWhereEachItemWasMetOnce) {
  // Four participants, two lists of one item each; two had list 0 natural, two list 1. The
  // C(4, 2) = 6 ways to deal the versions; only the observed one and its mirror are extreme.
  std::vector<ComparedTrial> trials;
  for (std::uint32_t participant = 0; participant < 4; ++participant) {
    for (std::uint32_t item = 0; item < 2; ++item) {
      const bool other = (participant % 2) != item;
      trials.push_back(answered(participant, item, other, 0, other ? 1 : 0));
    }
  }
  const auto found = permute_conditions(trials, kLabels, kLabels, 20'000, 1);
  EXPECT_EQ(found.randomisation, Randomisation::BetweenParticipants);
  EXPECT_NEAR(found.log10_arrangements, std::log10(6.0), 1e-9);
  EXPECT_NEAR(found.p.value(), 2.0 / 6.0, 0.014);
}

TEST(ConditionPermutation, ExchangesListByListInALatinSquareOfMoreConditions) {
  // Three conditions, of which two are compared: participant r met list (0 - r) mod 3 in the one
  // and list (1 - r) mod 3 in the other.
  std::vector<ComparedTrial> trials;
  for (std::uint32_t participant = 0; participant < 12; ++participant) {
    for (std::uint32_t item = 0; item < 6; ++item) {
      const auto condition = (item % 3 + participant) % 3;
      if (condition < 2) trials.push_back(answered(participant, item, condition == 1, 0, 0));
    }
  }
  const auto found = permute_conditions(trials, kLabels, kLabels, 100, 1);
  EXPECT_EQ(found.randomisation, Randomisation::WithinLists);
  EXPECT_EQ(found.left_out, 0);
  EXPECT_NEAR(found.log10_arrangements, 3.0 * std::log10(70.0), 1e-9);  // C(8, 4) for each list
}

TEST(ConditionPermutation, HasNoPWhereItemsAndConditionsAreOneThing) {
  std::vector<ComparedTrial> trials;
  for (std::uint32_t participant = 0; participant < 5; ++participant) {
    trials.push_back(answered(participant, 0, false, 0, 0));
    trials.push_back(answered(participant, 1, true, 1, 2));
  }
  const auto found = permute_conditions(trials, kLabels, kLabels, 100, 1);
  EXPECT_EQ(found.randomisation, Randomisation::None);
  EXPECT_FALSE(found.p);
}

TEST(ConditionPermutation, ForgivesTrialsThatWereLost) {
  std::vector<ComparedTrial> trials;
  for (std::uint32_t participant = 0; participant < 8; ++participant) {
    for (std::uint32_t item = 0; item < 40; ++item) {
      if (item == participant) continue;  // each lost another trial
      trials.push_back(answered(participant, item, (participant + item) % 2 == 1, item % 4, 0));
    }
  }
  const auto found = permute_conditions(trials, kLabels, kLabels, 100, 1);
  EXPECT_EQ(found.randomisation, Randomisation::BetweenParticipants);
  EXPECT_NEAR(found.log10_arrangements, std::log10(70.0), 1e-9);  // two versions of four
}

/// Simulated studies in which participants and items differ; the faces differ by `effect` (added to
/// the logit of being right with the synthetic face).
class Study {
 public:
  Study(Seed seed, double effect) : random_{seed}, effect_{effect} {
    for (auto& value : participants_) value = random_.normal();
    for (auto& value : items_) value = random_.normal();
  }

  std::vector<ComparedTrial> repeated() {
    std::vector<ComparedTrial> trials;
    for (std::uint32_t participant = 0; participant < kParticipants; ++participant) {
      for (std::uint32_t item = 0; item < kItems; ++item) {
        for (const bool other : {false, true}) trials.push_back(trial(participant, item, other));
      }
    }
    return trials;
  }

  /// Half of the participants, drawn at random, have the first half of the items natural.
  std::vector<ComparedTrial> in_lists() {
    std::vector<std::uint32_t> versions(kParticipants);
    for (std::uint32_t i = 0; i < kParticipants; ++i) versions[i] = i % 2;
    shuffle(std::span{versions}, random_);
    std::vector<ComparedTrial> trials;
    for (std::uint32_t participant = 0; participant < kParticipants; ++participant) {
      for (std::uint32_t item = 0; item < kItems; ++item) {
        const bool other = (item < kItems / 2) == (versions[participant] == 1);
        trials.push_back(trial(participant, item, other));
      }
    }
    return trials;
  }

  /// Three conditions by rotation, of which two are compared; the rotation drawn for each.
  std::vector<ComparedTrial> in_rotation() {
    std::vector<ComparedTrial> trials;
    std::vector<std::uint32_t> rotations(kParticipants);
    for (std::uint32_t i = 0; i < kParticipants; ++i) rotations[i] = i % 3;
    shuffle(std::span{rotations}, random_);
    for (std::uint32_t participant = 0; participant < kParticipants; ++participant) {
      for (std::uint32_t item = 0; item < kItems; ++item) {
        const auto condition = (item % 3 + rotations[participant]) % 3;
        if (condition < 2) trials.push_back(trial(participant, item, condition == 1));
      }
    }
    return trials;
  }

 private:
  static constexpr std::uint32_t kParticipants = 12;
  static constexpr std::uint32_t kItems = 24;

  ComparedTrial trial(std::uint32_t participant, std::uint32_t item, bool other) {
    const double logit = participants_.at(participant) + items_.at(item) + (other ? effect_ : 0.0);
    const auto stimulus = static_cast<std::uint32_t>(item % kLabels);
    const bool right = random_.uniform() < 1.0 / (1.0 + std::exp(-logit));
    const auto wrong = static_cast<std::uint32_t>((stimulus + 1 + random_.below(2)) % kLabels);
    return answered(participant, item, other, stimulus, right ? stimulus : wrong);
  }

  Random random_;
  double effect_;
  std::array<double, kParticipants> participants_{};
  std::array<double, kItems> items_{};
};

struct Rejections {
  int overall = 0;
  int accuracy = 0;
  int any_cell = 0;
};

/// At .05, of studies simulated one after the other.
template <typename Design>
Rejections reject(int studies, double effect, Randomisation randomisation, Design design) {
  Rejections rejections;
  for (int i = 0; i < studies; ++i) {
    Study study{derive_seed(7, "study", {static_cast<std::uint64_t>(i)}), effect};
    const auto trials = std::invoke(design, study);
    const auto found = permute_conditions(trials, kLabels, kLabels, 199, static_cast<Seed>(i));
    EXPECT_EQ(found.randomisation, randomisation);
    rejections.overall += found.p.value() <= 0.05 ? 1 : 0;
    rejections.accuracy += found.accuracy_p.value() <= 0.05 ? 1 : 0;
    bool any = false;
    for (const auto& q : found.cell_q) any = any || (q && *q <= 0.05);
    rejections.any_cell += any ? 1 : 0;
  }
  return rejections;
}

// Of 1,000 studies without a difference 50 are expected to be called different; 29 to 71 are within
// three standard deviations (binomial: sqrt(1000 .05 .95) = 6.9).
TEST(ConditionPermutation, KeepsItsNominalRateInThousandStudiesWithRepeatedItems) {
  const auto found = reject(1'000, 0.0, Randomisation::WithinItems, &Study::repeated);
  EXPECT_THAT(found.overall, testing::AllOf(testing::Ge(29), testing::Le(71)));
  EXPECT_THAT(found.accuracy, testing::AllOf(testing::Ge(20), testing::Le(71)));
  EXPECT_LE(found.any_cell, 71);
}

TEST(ConditionPermutation, KeepsItsNominalRateInThousandStudiesWithLists) {
  const auto found = reject(1'000, 0.0, Randomisation::BetweenParticipants, &Study::in_lists);
  EXPECT_THAT(found.overall, testing::AllOf(testing::Ge(29), testing::Le(71)));
  EXPECT_THAT(found.accuracy, testing::AllOf(testing::Ge(29), testing::Le(71)));
  EXPECT_LE(found.any_cell, 71);
}

// List by list the test errs on the safe side: who is good is so on both lists.
TEST(ConditionPermutation, RarelyRejectsInThousandStudiesWithALatinSquare) {
  const auto found = reject(1'000, 0.0, Randomisation::WithinLists, &Study::in_rotation);
  EXPECT_LE(found.overall, 71);
  EXPECT_LE(found.accuracy, 71);
}

TEST(ConditionPermutation, FindsAPlantedDifference) {
  EXPECT_GE(reject(40, -1.5, Randomisation::WithinItems, &Study::repeated).overall, 38);
  EXPECT_GE(reject(40, -1.5, Randomisation::BetweenParticipants, &Study::in_lists).overall, 34);
  EXPECT_GE(reject(40, -1.5, Randomisation::WithinLists, &Study::in_rotation).overall, 25);
}

TEST(ConditionPermutation, DoesNotDependOnTheOrderOfTrials) {
  Study study{3, -1.0};
  auto trials = study.repeated();
  const auto one = permute_conditions(trials, kLabels, kLabels, 50, 9);
  const auto again = permute_conditions(trials, kLabels, kLabels, 50, 9);
  EXPECT_EQ(one.p, again.p);
  EXPECT_EQ(one.cell_q, again.cell_q);
  std::ranges::reverse(trials);
  const auto reversed = permute_conditions(trials, kLabels, kLabels, 50, 9);
  EXPECT_NEAR(reversed.chi_square, one.chi_square, 1e-9);
  EXPECT_EQ(reversed.log10_arrangements, one.log10_arrangements);
}

}  // namespace
}  // namespace bimodal::analysis
