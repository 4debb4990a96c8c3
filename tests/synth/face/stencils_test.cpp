#include "synth/face/stencils.hpp"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/error.hpp"
#include "synth/face/quad_normals.hpp"

namespace bimodal::synth {
namespace {

std::vector<glm::dvec3> cube_corners() {
  std::vector<glm::dvec3> corners;
  for (const double z : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double x : {-1.0, 1.0}) corners.emplace_back(x, y, z);
    }
  }
  return corners;
}

const std::vector<Face> kCubeFaces{
    {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

struct Skin {
  Cage cage;
  Stencils stencils;
};

const Skin& skin() {
  static const Skin result = [] {
    const auto file = asset("synth/assets/head/head.obj");
    auto cage = part(read_obj(file), "skin", file);
    Stencils stencils{cage.vertices.size(), cage.faces, 2};
    return Skin{std::move(cage), std::move(stencils)};
  }();
  return result;
}

TEST(Stencils, RefineACubeAsCatmullAndClarkDo) {
  // By hand. Face points: the middles. Edge points: the mean of the edge's middle and the mean of
  // two face points, e.g. ((1,1,0) + (1/2,1/2,0)) / 2. Corners, valence 3: (F + 2R) / 3 with
  // F = (1/3,1/3,1/3) and R = (2/3,2/3,2/3).
  const Stencils stencils{8, kCubeFaces, 1};
  ASSERT_EQ(stencils.fine_size(), 8U + 12U + 6U);
  EXPECT_EQ(stencils.quads().size(), 24U);
  std::vector<glm::vec3> fine;
  stencils.apply(cube_corners(), fine);
  EXPECT_NEAR(glm::distance(fine[7], glm::vec3{5.0F / 9.0F}), 0.0F, 1e-6F);
  const auto occurs = [&](const glm::vec3& point) {
    return std::ranges::any_of(fine,
                               [&](const auto& p) { return glm::distance(p, point) < 1e-6F; });
  };
  EXPECT_TRUE(occurs({0.75F, 0.75F, 0.0F}));
  EXPECT_TRUE(occurs({0.0F, -0.75F, 0.75F}));
  EXPECT_TRUE(occurs({1.0F, 0.0F, 0.0F}));
}

TEST(Stencils, TreatABoundaryAsACubicSpline) {
  // One square: corners keep 1/2 and take 1/4 from each neighbouring edge's middle, so 3/4 of
  // themselves and 1/8 of both neighbours; edges become middles.
  const Stencils stencils{4, std::vector<Face>{{0, 1, 2, 3}}, 1};
  const std::vector<glm::dvec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto corner = stencils.point(square, 0);
  EXPECT_DOUBLE_EQ(corner.x, 0.125);
  EXPECT_DOUBLE_EQ(corner.y, 0.125);
}

TEST(Stencils, OfTheSkinHaveTheKnownSize) {
  EXPECT_EQ(skin().cage.vertices.size(), 1599U);
  EXPECT_EQ(skin().stencils.fine_size(), 25423U);
  EXPECT_EQ(skin().stencils.quads().size(), 25280U);
  EXPECT_EQ(skin().stencils.weight_count(), 272487U);
}

TEST(Stencils, HaveRowsThatSumToOne) {
  const std::vector<double> ones(skin().cage.vertices.size(), 1.0);
  for (const float sum : skin().stencils.apply(ones)) ASSERT_NEAR(sum, 1.0F, 1e-6F);
}

TEST(Stencils, CommuteWithAffineMaps) {
  const glm::dmat3 linear{0.9, 0.2, -0.1, 0.3, 1.1, 0.4, -0.2, 0.1, 0.8};
  const glm::dvec3 shift{3.0, -7.0, 11.0};
  auto mapped = skin().cage.vertices;
  for (auto& point : mapped) point = linear * point + shift;
  for (std::size_t i = 0; i < skin().stencils.fine_size(); ++i) {
    const auto expected = linear * skin().stencils.point(skin().cage.vertices, i) + shift;
    ASSERT_LT(glm::distance(skin().stencils.point(mapped, i), expected), 1e-10);
  }
}

TEST(Stencils, RefuseFacesThatFitNoSurface) {
  EXPECT_THROW((Stencils{5, std::vector<Face>{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, 1}), Error);
}

TEST(QuadNormals, PointOutOfACubeAndAreUnitLong) {
  const Stencils stencils{8, kCubeFaces, 2};
  std::vector<glm::vec3> fine;
  std::vector<glm::vec3> normals;
  stencils.apply(cube_corners(), fine);
  quad_normals(fine, stencils.quads(), normals);
  for (std::size_t i = 0; i < fine.size(); ++i) {
    EXPECT_NEAR(glm::length(normals[i]), 1.0F, 1e-5F);
    EXPECT_GT(glm::dot(normals[i], fine[i]), 0.0F);
  }
}

}  // namespace
}  // namespace bimodal::synth
