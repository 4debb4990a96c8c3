#include "stimuli/base/random.hpp"

#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace bimodal {
namespace {

TEST(Random, GivesTheSameBitsOnEveryMachine) {
  Random random{0};
  // Computed with an independent Python implementation of SplitMix64 and xoshiro256**.
  EXPECT_EQ(random.bits(), 0x99ec5f36cb75f2b4U);
  EXPECT_EQ(random.bits(), 0xbf6e1f784956452aU);
}

TEST(Random, NormalHasMeanZeroAndUnitVariance) {
  Random random{7};
  double sum = 0;
  double squares = 0;
  constexpr int kDraws = 200'000;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 4.0 / std::sqrt(kDraws));
  EXPECT_NEAR(squares / kDraws, 1.0, 4.0 * std::sqrt(2.0 / kDraws));
}

TEST(Random, BelowIsUnbiasedForABoundThatIsNoPowerOfTwo) {
  Random random{11};
  std::array<int, 3> counts{};
  for (int i = 0; i < 30'000; ++i) ++counts.at(random.below(3));
  for (const int count : counts) EXPECT_NEAR(count, 10'000, 330);  // four standard deviations
}

TEST(Random, WeightedNeverDrawsAnImpossibleItem) {
  Random random{13};
  const std::array weights{0.0, 1.0, 0.0, 3.0, 0.0};
  std::array<int, 5> counts{};
  for (int i = 0; i < 40'000; ++i) ++counts.at(random.weighted(weights));
  EXPECT_EQ(counts[0] + counts[2] + counts[4], 0);
  EXPECT_NEAR(counts[3], 30'000, 350);
}

TEST(Shuffle, ReachesEveryOrder) {
  Random random{17};
  std::set<std::vector<int>> orders;
  for (int i = 0; i < 1'000; ++i) {
    std::vector<int> items{1, 2, 3, 4};
    shuffle(std::span{items}, random);
    orders.insert(items);
  }
  EXPECT_EQ(orders.size(), 24U);
}

TEST(DeriveSeed, SeparatesPurposesAndIndices) {
  std::set<Seed> seeds;
  for (std::uint64_t i = 0; i < 1'000; ++i) {
    seeds.insert(derive_seed(1, "noise", {i}));
    seeds.insert(derive_seed(1, "order", {i}));
    seeds.insert(derive_seed(i + 2, "noise"));
  }
  EXPECT_EQ(seeds.size(), 3'000U);
}

}  // namespace
}  // namespace bimodal
