#include "analysis/statistics/noise_ceiling.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "analysis/statistics/correlation.hpp"
#include "analysis/statistics/matrix_comparison.hpp"
#include "tests/analysis/statistics/viseme_truth.hpp"

namespace bimodal::analysis {
namespace {

constexpr std::int64_t kResponses = 80;  ///< a row
constexpr std::int64_t kSplits = 20;
constexpr int kStudies = 20;

ConfusionMatrix drawn(const VisemeTruth& truth, Random& random) {
  CellCounts counts;
  truth.sampler(kResponses).draw(random, counts);
  return VisemeTruth::matrix_of(counts);
}

/// Means over simulated studies, off the diagonal.
struct Simulated {
  double within = 0.0;
  double across = 0.0;
  double share = 0.0;
  double corrected = 0.0;
  double full = 0.0;  ///< the correlation of all data of the one with all of the other
};

Simulated simulate(const VisemeTruth& one, const VisemeTruth& other) {
  Random random{11};
  Simulated means;
  for (int i = 0; i < kStudies; ++i) {
    const auto ones = drawn(one, random);
    const auto others = drawn(other, random);
    const auto found = noise_ceiling(ones, others, true, kSplits, static_cast<Seed>(i));
    means.within += found.within.value() / kStudies;
    means.across += found.across.value() / kStudies;
    means.share += found.share.value() / kStudies;
    means.corrected += found.corrected.value() / kStudies;
    means.full += agreement_of_cells(ones, others, true).pearson.value() / kStudies;
  }
  return means;
}

/// Half of the data is noisier than all of it: what two halves of one face reach is no ceiling for
/// what all data of two faces reach. Like is compared with like, and the correction of Spearman and
/// Brown says what all data of one face would reach.
TEST(NoiseCeiling, ComparesHalvesWithHalves) {
  const VisemeTruth face{0.6};
  const auto found = simulate(face, face);
  EXPECT_NEAR(found.across, found.within, 0.02);
  EXPECT_NEAR(found.share, 1.0, 0.03);
  EXPECT_LT(found.within, found.full - 0.05);
  EXPECT_NEAR(found.corrected, found.full, 0.02);
}

TEST(NoiseCeiling, IsNotReachedByAnotherFace) {
  const VisemeTruth natural{0.6};
  VisemeTruth synthetic{0.6};
  synthetic.confuse(0, 3);  // /p/ looks like /f/
  synthetic.confuse(7, 16);
  EXPECT_LT(simulate(natural, synthetic).share, 0.9);
}

/// A study of 8 participants with 10 responses a row each.
std::vector<ParticipantConfusions> participants(const VisemeTruth& natural,
                                                const VisemeTruth& synthetic,
                                                Random& random) {
  std::vector<ParticipantConfusions> all;
  CellCounts one;
  CellCounts other;
  for (int i = 0; i < 8; ++i) {
    natural.sampler(kResponses / 8).draw(random, one);
    synthetic.sampler(kResponses / 8).draw(random, other);
    all.push_back({VisemeTruth::matrix_of(one), VisemeTruth::matrix_of(other)});
  }
  return all;
}

TEST(NoiseCeiling, TakesHalvesOfParticipants) {
  Random random{12};
  const VisemeTruth natural{0.6};
  VisemeTruth synthetic{0.6};
  synthetic.confuse(0, 3);
  synthetic.confuse(7, 16);
  double alike = 0.0;
  double unlike = 0.0;
  for (int i = 0; i < kStudies; ++i) {
    const auto same =
        noise_ceiling(participants(natural, natural, random), true, kSplits, static_cast<Seed>(i));
    EXPECT_TRUE(same.by_participants);
    EXPECT_EQ(same.splits, kSplits);
    alike += same.share.value() / kStudies;
    unlike +=
        noise_ceiling(participants(natural, synthetic, random), true, kSplits, static_cast<Seed>(i))
            .share.value() /
        kStudies;
  }
  EXPECT_NEAR(alike, 1.0, 0.03);
  EXPECT_LT(unlike, 0.9);
}

TEST(NoiseCeiling, IsTheSameForTheSameSeedAndAbsentWithoutSpread) {
  Random random{13};
  const auto one = drawn(VisemeTruth{0.6}, random);
  const auto other = drawn(VisemeTruth{0.6}, random);
  EXPECT_EQ(noise_ceiling(one, other, true, 5, 1).within,
            noise_ceiling(one, other, true, 5, 1).within);
  EXPECT_NE(noise_ceiling(one, other, true, 5, 1).within,
            noise_ceiling(one, other, true, 5, 2).within);
  const ConfusionMatrix perfect{{"p", "b"}, {"p", "b"}, {9, 0, 0, 9}};
  const auto found = noise_ceiling(perfect, perfect, true, 5, 1);
  EXPECT_FALSE(found.within);
  EXPECT_FALSE(found.share);
  EXPECT_FALSE(found.corrected);
}

}  // namespace
}  // namespace bimodal::analysis
