#include "synth/face/tongue_contact.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"
#include "synth/face/palate.hpp"
#include "synth/face/surface_tree.hpp"
#include "synth/face/tooth_row.hpp"
#include "tests/synth/face/the_head.hpp"

namespace bimodal::synth {
namespace {

using enum Control;

const SurfaceDescription& description(HeadSurface name) {
  return the_head().surfaces()[static_cast<std::size_t>(name)];
}

ToothRow row(HeadSurface name, ToothRow::Jaw jaw) {
  const auto head = posed(neutral_pose());
  return {head.at(name).positions, description(name).triangles, jaw};
}

TEST(ToothRow, LeavesTheTongueRoomBehindTheIncisorsAndBetweenTheMolars) {
  const auto upper = row(HeadSurface::UpperTeeth, ToothRow::Jaw::Upper);
  EXPECT_LT(upper.at(0, 80).beyond, -5);
  EXPECT_LT(upper.at(10, 60).beyond, -3);
  EXPECT_GT(upper.at(0, 92).beyond, 0.5);
  EXPECT_GT(upper.at(24, 62).beyond, 2);
  EXPECT_GT(upper.at(0, 100).beyond, 5);  // before the teeth is not where the tongue has room
}

TEST(ToothRow, PointsBackToTheRoom) {
  const auto upper = row(HeadSurface::UpperTeeth, ToothRow::Jaw::Upper);
  EXPECT_LT(upper.at(0.3, 92).inward.y, -0.9);
  EXPECT_LT(upper.at(21.5, 73).inward.x, -0.8);
  EXPECT_GT(upper.at(-21.5, 73).inward.x, 0.8);
}

TEST(ToothRow, KnowsHowFarTheIncisorsComeDown) {
  const auto upper = row(HeadSurface::UpperTeeth, ToothRow::Jaw::Upper);
  const auto lower = row(HeadSurface::LowerTeeth, ToothRow::Jaw::Lower);
  EXPECT_NEAR(upper.at(4, 92).edge_y, -78, 0.8);
  EXPECT_NEAR(lower.at(3, 89).edge_y, -75.6, 0.8);
  EXPECT_GT(upper.depth(upper.at(4, 92), -76), 1);
  EXPECT_LT(upper.depth(upper.at(4, 92), -80), 0);
  EXPECT_GT(lower.depth(lower.at(3, 89), -77), 0.5);
}

TEST(Palate, VaultsBetweenTheTeethAndFallsBehindThem) {
  EXPECT_GT(palate_y(0, 62), palate_y(0, 79));
  EXPECT_GT(palate_y(0, 62), palate_y(12, 62) + 1);
  EXPECT_GT(palate_y(0, 79), palate_y(0, 88) + 3);
  EXPECT_DOUBLE_EQ(palate_y(-7, 70), palate_y(7, 70));
}

/// Whatever the controls ask for, nothing of the tongue goes deeper into a tooth than 0.2 mm.
TEST(TongueContact, KeepsTheTongueOutOfTheTeethWhateverIsAsked) {
  const auto resting = posed(neutral_pose());
  const SurfaceTree upper{resting.at(HeadSurface::UpperTeeth).positions,
                          description(HeadSurface::UpperTeeth).triangles};
  const SurfaceTree lower{resting.at(HeadSurface::LowerTeeth).positions,
                          description(HeadSurface::LowerTeeth).triangles};
  Random random{11};
  constexpr float kMostMm = 0.2F;
  constexpr float kFar = 6;
  for (int i = 0; i < 60; ++i) {
    Pose pose = neutral_pose();
    for (const Control control :
         {Jaw, TongueLength, TongueAngle, TongueWidth, TongueThickness, TongueTip, TongueBack}) {
      const auto& range = describe(control);
      value(pose, control) = range.lowest + (range.highest - range.lowest) * random.uniform();
    }
    value(pose, Jaw) *= 0.5;
    const JawMotion jaw{.opening_deg = value(pose, Jaw), .thrust_mm = 0};
    const auto head = posed(pose);
    float deepest = 0;
    for (const auto& point : head.at(HeadSurface::Tongue).positions) {
      deepest = std::min({deepest,
                          upper.signed_distance(point, kFar),
                          lower.signed_distance(glm::vec3{jaw.undo(glm::dvec3{point})}, kFar)});
    }
    EXPECT_GT(deepest, -kMostMm) << "pose " << i;
  }
}

TEST(TongueContact, KeepsTheTongueBelowThePalate) {
  const auto head =
      posed(pose_of({{Jaw, 6}, {TongueBack, 18}, {TongueTip, 16}, {TongueAngle, 20}}));
  for (const auto& point : head.at(HeadSurface::Tongue).positions) {
    const glm::dvec3 at{point};
    if (at.z > kPalateFront || std::abs(at.x) > palate_half_width(at.z)) continue;
    EXPECT_LE(at.y, palate_y(at.x, at.z));
  }
}

}  // namespace
}  // namespace bimodal::synth
