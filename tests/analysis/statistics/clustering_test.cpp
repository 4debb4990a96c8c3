#include "analysis/statistics/clustering.hpp"

#include <algorithm>
#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal::analysis {
namespace {

using testing::ElementsAre;

constexpr double kExact = 1e-12;

ConfusionMatrix example() {
  const std::vector<std::string> labels{"p", "b", "m", "t", "d", "n"};
  return {labels, labels, {40, 6, 2, 9,  2, 1, 7, 35, 6, 2, 8,  2, 1, 5, 44, 0, 3, 7,
                           12, 2, 0, 38, 6, 2, 2, 9,  2, 8, 33, 6, 1, 2, 10, 1, 5, 41}};
}

Dissimilarities unlike() {
  return dissimilarities(example(), DissimilarityMeasure::Phi);
}

/// scipy 1.10.1, stats.chi2_contingency of the two rows without empty columns.
TEST(Dissimilarity, IsThePhiOfScipy) {
  const auto found = unlike();
  EXPECT_NEAR(found.between(0, 1), 0.6712568229062769, kExact);
  EXPECT_NEAR(found.between(3, 2), 0.8961546758753218, kExact);
  EXPECT_EQ(found.between(4, 4), 0.0);
}

TEST(Dissimilarity, OfConfusionsIsOneLessTheirMean) {
  const auto found = dissimilarities(example(), DissimilarityMeasure::Confusion);
  EXPECT_NEAR(found.between(0, 3), 1.0 - (9.0 / 60.0 + 12.0 / 60.0) / 2.0, kExact);
}

TEST(Dissimilarity, LeavesOutStimuliThatWereNotPresented) {
  const ConfusionMatrix matrix{{"p", "b", "m"}, {"p", "x"}, {3, 0, 0, 0, 0, 2}};
  const auto found = dissimilarities(matrix, DissimilarityMeasure::Phi);
  EXPECT_THAT(found.labels(), ElementsAre("p", "m"));
  EXPECT_NEAR(found.between(0, 1), 1.0, kExact);  // nothing in common
}

struct Expected {
  std::size_t one;
  std::size_t other;
  double height;
  std::size_t members;
};

void expect_merges(Linkage linkage, const std::array<Expected, 5>& expected) {
  const auto merges = cluster(unlike(), linkage);
  ASSERT_EQ(merges.size(), expected.size());
  for (std::size_t k = 0; k < merges.size(); ++k) {
    EXPECT_EQ(merges[k].one, expected[k].one) << k;
    EXPECT_EQ(merges[k].other, expected[k].other) << k;
    EXPECT_NEAR(merges[k].height, expected[k].height, kExact) << k;
    EXPECT_EQ(merges[k].members, expected[k].members) << k;
  }
}

/// scipy 1.10.1, cluster.hierarchy.linkage of the same dissimilarities.
TEST(Clustering, IsThatOfScipy) {
  expect_merges(Linkage::Single,
                {{{0, 3, 0.5723043583584773, 2},
                  {1, 4, 0.5844179196747715, 2},
                  {2, 5, 0.6342742245173811, 2},
                  {6, 7, 0.6699186995512629, 4},
                  {8, 9, 0.7203070253964569, 6}}});
  expect_merges(Linkage::Complete,
                {{{0, 3, 0.5723043583584773, 2},
                  {1, 4, 0.5844179196747715, 2},
                  {2, 5, 0.6342742245173811, 2},
                  {6, 7, 0.7606682160652727, 4},
                  {8, 9, 0.8961546758753218, 6}}});
  expect_merges(Linkage::Average,
                {{{0, 3, 0.5723043583584773, 2},
                  {1, 4, 0.5844179196747715, 2},
                  {2, 5, 0.6342742245173811, 2},
                  {6, 7, 0.7109618714810659, 4},
                  {8, 9, 0.8107308075389549, 6}}});
}

TEST(Clustering, OrdersLeavesAndCutsIntoClasses) {
  const auto merges = cluster(unlike(), Linkage::Average);
  EXPECT_THAT(leaf_order(merges), ElementsAre(2, 5, 0, 3, 1, 4));
  EXPECT_THAT(classes_after(merges, 0).size(), 6U);
  EXPECT_THAT(classes_after(merges, 4), ElementsAre(ElementsAre(0, 1, 3, 4), ElementsAre(2, 5)));
  EXPECT_THAT(classes_after(merges, 5).size(), 1U);
}

TEST(Visemes, AreTheFewestMergesThatKeepThreeQuarters) {
  const auto matrix = example();
  const auto labels = unlike().labels();
  const auto merges = cluster(unlike(), Linkage::Average);
  // {p t}: 99 of 120; {b d}: 85 of 120; {m n}: 102 of 120; {p b t d}: 219 of 240
  EXPECT_NEAR(kept_within(matrix, {"b", "d"}), 85.0 / 120.0, kExact);
  EXPECT_EQ(merges_until_kept(matrix, labels, merges, 0.55), 0U);
  EXPECT_EQ(merges_until_kept(matrix, labels, merges, 0.70), 3U);
  EXPECT_EQ(merges_until_kept(matrix, labels, merges, 0.75), 4U);
  EXPECT_EQ(merges_until_kept(matrix, labels, merges, 0.99), 5U);
}

TEST(Clustering, NeverFallsAndKeepsEveryThing) {
  Random random{9};
  for (int round = 0; round < 200; ++round) {
    const auto n = 1 + random.below(12);
    Dissimilarities random_ones{std::vector<std::string>(n)};
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) random_ones.set(i, j, random.uniform());
    }
    for (const auto linkage : {Linkage::Single, Linkage::Complete, Linkage::Average}) {
      const auto merges = cluster(random_ones, linkage);
      ASSERT_EQ(merges.size(), n - 1);
      EXPECT_TRUE(std::ranges::is_sorted(merges, {}, &Merge::height));
      auto order = leaf_order(merges);
      std::ranges::sort(order);
      for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(order.at(i), i);
      const auto count = random.below(n);
      EXPECT_EQ(classes_after(merges, count).size(), n - count);
    }
  }
}

}  // namespace
}  // namespace bimodal::analysis
