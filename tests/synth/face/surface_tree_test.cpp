#include "synth/face/surface_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"
#include "synth/face/surface.hpp"
#include "tests/synth/face/the_head.hpp"

namespace bimodal::synth {
namespace {

constexpr float kFar = 1000.0F;

/// A cube from -1 to 1.
SurfaceTree cube() {
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
  }
  const std::vector<std::uint32_t> triangles{0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                             2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  return {corners, triangles};
}

float distance_from_cube(const glm::vec3& point) {
  const glm::vec3 beyond = glm::abs(point) - 1.0F;
  return glm::length(glm::max(beyond, 0.0F)) +
         std::min(0.0F, std::max({beyond.x, beyond.y, beyond.z}));
}

glm::vec3 random_point(Random& random, const glm::vec3& least, const glm::vec3& most) {
  const auto part = [&] { return static_cast<float>(random.uniform()); };
  return least + (most - least) * glm::vec3{part(), part(), part()};
}

TEST(SurfaceTree, KnowsDistanceAndSideOfAnEdgedBody) {
  const auto tree = cube();
  Random random{7};
  for (int i = 0; i < 2000; ++i) {
    const auto point = random_point(random, glm::vec3{-3}, glm::vec3{3});
    EXPECT_NEAR(tree.signed_distance(point, kFar), distance_from_cube(point), 1e-5F);
  }
}

TEST(SurfaceTree, KnowsTheSideAtEdgesAndCorners) {
  const auto tree = cube();
  EXPECT_NEAR(tree.signed_distance({2, 2, 2}, kFar), std::sqrt(3.0F), 1e-5F);
  EXPECT_NEAR(tree.signed_distance({1.5F, 1.5F, 0.2F}, kFar), std::sqrt(0.5F), 1e-5F);
  EXPECT_NEAR(tree.signed_distance({0.9F, 0.9F, 0.9F}, kFar), -0.1F, 1e-5F);
}

TEST(SurfaceTree, SaysOnlyThatAPointIsFarther) {
  EXPECT_EQ(cube().signed_distance({9, 0, 0}, 2.0F), 2.0F);
}

TEST(SurfaceTree, OfNothingIsFarFromEverything) {
  EXPECT_EQ((SurfaceTree{{}, {}}.signed_distance({0, 0, 0}, 5.0F)), 5.0F);
}

/// The nearest corner is never nearer than the nearest point of the surface, and not much farther.
TEST(SurfaceTree, OfTheTeethAgreesWithASearchThroughAllCorners) {
  const auto head = posed(neutral_pose());
  const auto& teeth = head.at(HeadSurface::UpperTeeth).positions;
  const auto& triangles =
      the_head().surfaces()[static_cast<std::size_t>(HeadSurface::UpperTeeth)].triangles;
  const SurfaceTree tree{teeth, triangles};
  constexpr float kLongestEdge = 2.5F;
  Random random{8};
  for (int i = 0; i < 300; ++i) {
    const auto point = random_point(random, {-30, -84, 50}, {30, -60, 100});
    float to_corner = std::numeric_limits<float>::infinity();
    for (const auto& corner : teeth) to_corner = std::min(to_corner, glm::distance(corner, point));
    const float distance = std::abs(tree.signed_distance(point, kFar));
    EXPECT_LE(distance, to_corner + 1e-4F);
    EXPECT_GE(distance, to_corner - kLongestEdge);
  }
}

}  // namespace
}  // namespace bimodal::synth
