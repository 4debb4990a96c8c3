#include "synth/face/head.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"
#include "tests/synth/face/the_head.hpp"
#include "tests/synth/face/written_file.hpp"

namespace bimodal::synth {
namespace {

using enum Control;

bool finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void expect_well_formed(const PosedHead& head) {
  for (std::size_t i = 0; i < head.surfaces.size(); ++i) {
    for (const auto& point : head.surfaces[i].positions) {
      ASSERT_TRUE(finite(point)) << "surface " << i;
      ASSERT_LT(glm::length(point), 400.0F) << "surface " << i;
    }
    for (const auto& normal : head.surfaces[i].normals) {
      ASSERT_NEAR(glm::length(normal), 1.0F, 1e-3F) << "surface " << i;
    }
  }
  for (const double measure : {head.lips.inner_height_mm,
                               head.lips.inner_width_mm,
                               head.lips.inner_area_mm2,
                               head.lips.outer_width_mm,
                               head.lips.chin_drop_mm}) {
    ASSERT_TRUE(std::isfinite(measure));
  }
}

const SurfaceGeometry& skin(const PosedHead& head) {
  return head.surfaces.front();
}

float largest_move(const SurfaceGeometry& a, const SurfaceGeometry& b) {
  float largest = 0.0F;
  for (std::size_t i = 0; i < a.positions.size(); ++i) {
    largest = std::max(largest, glm::distance(a.positions[i], b.positions[i]));
  }
  return largest;
}

TEST(Head, DescribesEachSurfaceCompletely) {
  for (const auto& surface : the_head().surfaces()) {
    const auto vertices = surface.rest_positions.size();
    ASSERT_GT(vertices, 0U);
    EXPECT_EQ(surface.lip.size(), vertices);
    EXPECT_EQ(surface.wet.size(), vertices);
    EXPECT_EQ(surface.scalp.size(), vertices);
    EXPECT_EQ(surface.special.size(), vertices);
    EXPECT_EQ(surface.triangles.size() % 3, 0U);
    EXPECT_TRUE(std::ranges::all_of(surface.triangles, [&](auto v) { return v < vertices; }));
  }
}

TEST(Head, HasItsSurfacesWhereTheyAreLookedFor) {
  constexpr std::array kNames{
      "skin", "tongue", "lashes", "upper_teeth", "lower_teeth", "upper_gum", "lower_gum", "palate"};
  static_assert(kNames.size() == static_cast<std::size_t>(HeadSurface::Palate) + 1);
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    EXPECT_EQ(the_head().surfaces()[i].name, kNames.at(i));
  }
}

TEST(Head, HasEveryMaterial) {
  for (const auto material : {Material::Skin,
                              Material::Tooth,
                              Material::Gum,
                              Material::Tongue,
                              Material::Eye,
                              Material::Cornea,
                              Material::Lash}) {
    EXPECT_TRUE(std::ranges::any_of(the_head().surfaces(),
                                    [&](const auto& s) { return s.material == material; }));
  }
}

TEST(Head, PosesEverySurfaceAsDescribed) {
  const auto head = posed(neutral_pose());
  const auto surfaces = the_head().surfaces();
  ASSERT_EQ(head.surfaces.size(), surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    EXPECT_EQ(head.surfaces[i].positions.size(), surfaces[i].rest_positions.size());
    EXPECT_EQ(head.surfaces[i].normals.size(), surfaces[i].rest_positions.size());
  }
  expect_well_formed(head);
}

TEST(Head, StaysWellFormedAtBothEndsOfEveryControl) {
  for (const auto& control : controls()) {
    for (const double end : {control.lowest, control.highest}) {
      SCOPED_TRACE(control.name);
      expect_well_formed(posed(pose_of({{control.control, end}})));
    }
  }
}

TEST(Head, ClampsControlsToTheirRanges) {
  const auto beyond = posed(pose_of({{Jaw, 90.0}, {LipWidth, -100.0}, {LidClosure, 3.0}}));
  const auto end = posed(pose_of({{Jaw, 22.0}, {LipWidth, -22.0}, {LidClosure, 1.0}}));
  EXPECT_EQ(skin(beyond).positions, skin(end).positions);
}

TEST(Head, EveryControlMovesSomething) {
  const auto rest = posed(neutral_pose());
  for (const auto& control : controls()) {
    const double end = control.highest == control.neutral ? control.lowest : control.highest;
    Pose pose = pose_of({{control.control, end}});
    if (control.control == LipClosure) value(pose, Jaw) = 5.0;
    auto compared = rest;
    if (control.control == LipClosure) compared = posed(pose_of({{Jaw, 5.0}}));
    const auto moved = posed(pose);
    float largest = 0.0F;
    for (std::size_t i = 0; i < moved.surfaces.size(); ++i) {
      largest = std::max(largest, largest_move(moved.surfaces[i], compared.surfaces[i]));
    }
    EXPECT_GT(largest, 1.0F) << control.name;
  }
}

TEST(Head, IsSymmetricWhenTheControlsAre) {
  const auto head = posed(pose_of({{Jaw, 6},
                                   {LipWidth, -7},
                                   {LipProtrusion, 3},
                                   {LowerLipTuck, 0.4},
                                   {LipClosure, 0.3},
                                   {CornerY, 2},
                                   {LidClosure, 0.4}}));
  const auto& cage = head.skin_cage;
  for (const auto& point : cage) {
    const glm::dvec3 mirrored{-point.x, point.y, point.z};
    const bool found = std::ranges::any_of(
        cage, [&](const auto& other) { return glm::distance(other, mirrored) < 1e-9; });
    ASSERT_TRUE(found);
  }
}

TEST(Head, HasFacesThatLookOutward) {
  const auto head = posed(neutral_pose());
  const auto surfaces = the_head().surfaces();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i].material == Material::Lash || surfaces[i].material == Material::Gum) continue;
    const auto& points = head.surfaces[i].positions;
    glm::dvec3 middle{0.0};
    for (const auto& point : points) middle += glm::dvec3{point};
    middle /= static_cast<double>(points.size());
    double six_volumes = 0.0;
    for (std::size_t t = 0; t < surfaces[i].triangles.size(); t += 3) {
      const auto corner = [&](std::size_t k) {
        return glm::dvec3{points[surfaces[i].triangles[t + k]]} - middle;
      };
      six_volumes += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
    }
    EXPECT_GT(six_volumes, 0.0) << "surface " << i;
  }
}

TEST(Head, TurnsAllButTheNeckBaseAsOne) {
  const auto straight = posed(pose_of({{Jaw, 5}}));
  const auto turned = posed(pose_of({{Jaw, 5}, {HeadYaw, 20}, {HeadPitch, -10}, {HeadRoll, 5}}));
  const auto& a = straight.surfaces[3].positions;  // upper teeth
  const auto& b = turned.surfaces[3].positions;
  for (std::size_t i = 1; i < a.size(); ++i) {
    ASSERT_NEAR(glm::distance(a[0], a[i]), glm::distance(b[0], b[i]), 1e-3F);
  }
  // The lowest skin, at the base of the neck, stays.
  const auto lowest = std::ranges::min_element(skin(straight).positions, {}, &glm::vec3::y);
  const auto i = std::distance(skin(straight).positions.begin(), lowest);
  EXPECT_LT(glm::distance(*lowest, *std::next(skin(turned).positions.begin(), i)), 0.5F);
  // Yaw goes to the subject's left, +x.
  const auto nose = std::ranges::max_element(skin(straight).positions, {}, &glm::vec3::z);
  const auto n = std::distance(skin(straight).positions.begin(), nose);
  EXPECT_GT(std::next(skin(turned).positions.begin(), n)->x, 30.0F);
}

TEST(Head, LooksToTheSubjectsLeftAndDown) {
  const auto surfaces = the_head().surfaces();
  const auto ball = std::ranges::find(surfaces, Material::Eye, &SurfaceDescription::material);
  const auto index = static_cast<std::size_t>(std::distance(surfaces.begin(), ball));
  const auto pupil = static_cast<std::size_t>(
      std::distance(ball->rest_positions.begin(),
                    std::ranges::max_element(ball->rest_positions, {}, &glm::vec3::z)));
  const auto ahead = posed(neutral_pose()).surfaces[index].positions[pupil];
  const auto aside = posed(pose_of({{GazeX, 20}, {GazeY, 10}})).surfaces[index].positions[pupil];
  EXPECT_GT(aside.x, ahead.x + 3.0F);
  EXPECT_LT(aside.y, ahead.y - 1.5F);
}

TEST(Head, GivesTheSameInEveryThread) {
  const auto pose = pose_of({{Jaw, 7}, {LowerLipTuck, 0.6}, {TongueTip, 8}, {HeadYaw, 12}});
  const auto expected = posed(pose);
  std::array<PosedHead, 4> results;
  {
    std::vector<std::jthread> threads;
    for (auto& result : results) {
      threads.emplace_back([&result, &pose] {
        for (int i = 0; i < 5; ++i) {
          the_head().pose(pose_of({{Jaw, 1.0 * i}}), result);
          the_head().pose(pose, result);
        }
      });
    }
  }
  for (const auto& result : results) {
    for (std::size_t i = 0; i < expected.surfaces.size(); ++i) {
      EXPECT_EQ(result.surfaces[i].positions, expected.surfaces[i].positions);
      EXPECT_EQ(result.surfaces[i].normals, expected.surfaces[i].normals);
    }
  }
}

/// Half of the controls anywhere in their ranges, the others neutral.
Pose random_pose(Random& random) {
  Pose pose = neutral_pose();
  for (const auto& control : controls()) {
    if (random.uniform() < 0.5) continue;
    value(pose, control.control) =
        control.lowest + random.uniform() * (control.highest - control.lowest);
  }
  return pose;
}

void expect_the_same(const PosedHead& used, const PosedHead& fresh) {
  for (std::size_t i = 0; i < fresh.surfaces.size(); ++i) {
    ASSERT_EQ(used.surfaces[i].positions, fresh.surfaces[i].positions) << "surface " << i;
    ASSERT_EQ(used.surfaces[i].normals, fresh.surfaces[i].normals) << "surface " << i;
  }
  EXPECT_EQ(used.skin_cage, fresh.skin_cage);
  EXPECT_EQ(used.lips.inner_area_mm2, fresh.lips.inner_area_mm2);
  EXPECT_EQ(used.lips.inner_centre, fresh.lips.inner_centre);
}

TEST(Head, PosesAUsedHeadAsAFreshOne) {
  Random random{41};
  PosedHead used;
  for (int i = 0; i < 60; ++i) {
    const auto pose = random_pose(random);
    the_head().pose(pose, used);
    expect_the_same(used, posed(pose));
  }
}

TEST(Head, PosesWhatAnotherHeadHasPosed) {
  const auto pose = pose_of({{Jaw, 4}, {GazeX, 10}});
  PosedHead used;
  {
    const Head other{asset("synth/assets/head")};
    other.pose(pose, used);
  }
  for (auto& surface : used.surfaces) surface = {};
  the_head().pose(pose, used);
  expect_the_same(used, posed(pose));
}

TEST(Head, SaysWhichFileIsMissing) {
  try {
    const Head head{"no/such/folder"};
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string_view{error.what()}.find("no/such/folder/head.obj"),
              std::string_view::npos);
  }
}

}  // namespace
}  // namespace bimodal::synth
