#include "analysis/statistics/scaling.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {
namespace {

constexpr double kExact = 1e-9;

/// numpy 1.24.2: linalg.eigh of -1/2 J D^2 J, D as in clustering_test.cpp.
TEST(Scaling, IsThatOfNumpy) {
  const std::vector<std::string> labels{"p", "b", "m", "t", "d", "n"};
  const ConfusionMatrix matrix{
      labels, labels, {40, 6, 2, 9,  2, 1, 7, 35, 6, 2, 8,  2, 1, 5, 44, 0, 3, 7,
                       12, 2, 0, 38, 6, 2, 2, 9,  2, 8, 33, 6, 1, 2, 10, 1, 5, 41}};
  const auto layout = scale_classically(dissimilarities(matrix, DissimilarityMeasure::Phi), 2);
  ASSERT_EQ(layout.coordinates.size(), 12U);
  EXPECT_NEAR(layout.eigenvalues[0], 0.5814304940027238, kExact);
  EXPECT_NEAR(layout.eigenvalues[4], 0.1065824338542861, kExact);
  EXPECT_NEAR(layout.coordinates[0], -0.3499279982168624, kExact);
  EXPECT_NEAR(layout.coordinates[1], -0.15409207617013929, kExact);
  EXPECT_NEAR(layout.coordinates[11], -0.1567461000386921, kExact);
  EXPECT_NEAR(layout.share, 0.6176626093866604, kExact);
  EXPECT_NEAR(layout.stress, 0.4621438626424933, kExact);
}

TEST(Scaling, FindsALayoutThatThereIs) {
  Dissimilarities triangle{{"a", "b", "c"}};
  triangle.set(0, 1, 3.0);
  triangle.set(1, 2, 4.0);
  triangle.set(0, 2, 5.0);
  const auto layout = scale_classically(triangle, 2);
  EXPECT_NEAR(layout.stress, 0.0, kExact);
  EXPECT_NEAR(layout.share, 1.0, kExact);
  const auto& at = layout.coordinates;
  EXPECT_NEAR(std::hypot(at[0] - at[4], at[1] - at[5]), 5.0, kExact);
}

TEST(Scaling, LeavesDimensionsEmptyThatThereAreNot) {
  Dissimilarities pair{{"a", "b"}};
  pair.set(0, 1, 2.0);
  const auto layout = scale_classically(pair, 3);
  EXPECT_NEAR(std::abs(layout.coordinates[0]), 1.0, kExact);
  EXPECT_EQ(layout.coordinates[1], 0.0);
  EXPECT_EQ(layout.coordinates[5], 0.0);
  EXPECT_TRUE(scale_classically(Dissimilarities{{}}, 2).coordinates.empty());
  EXPECT_EQ(scale_classically(Dissimilarities{{"a", "b"}}, 2).stress, 0.0);  // all alike
}

}  // namespace
}  // namespace bimodal::analysis
