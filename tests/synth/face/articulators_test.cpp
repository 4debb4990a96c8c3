// The movable parts behind the lips, each by itself.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "synth/face/dental_arch.hpp"
#include "synth/face/eyeball.hpp"
#include "synth/face/field_table.hpp"
#include "synth/face/jaw.hpp"
#include "synth/face/obj_reader.hpp"
#include "synth/face/rigid_motion.hpp"
#include "synth/face/smoothing.hpp"
#include "synth/face/tongue.hpp"
#include "tests/synth/face/the_head.hpp"

namespace bimodal::synth {
namespace {

using enum Control;

TEST(RigidMotion, TurnsRightHanded) {
  const glm::dvec3 ahead{0, 0, 1};
  EXPECT_NEAR(glm::distance(rotation_about_x(90) * ahead, glm::dvec3{0, -1, 0}), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(rotation_about_y(90) * ahead, glm::dvec3{1, 0, 0}), 0.0, 1e-12);
  EXPECT_NEAR(
      glm::distance(rotation_about_z(90) * glm::dvec3{1, 0, 0}, glm::dvec3{0, 1, 0}), 0.0, 1e-12);
}

TEST(RigidMotion, ComposesInTheOrderSaid) {
  const auto turn = rotation_about({1, 2, 3}, rotation_about_y(40));
  const RigidMotion shift{.rotation = glm::dmat3{1.0}, .translation = {5, 0, -2}};
  const glm::dvec3 point{7, -3, 4};
  EXPECT_NEAR(
      glm::distance(shift.after(turn).move(point), shift.move(turn.move(point))), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(turn.move({1, 2, 3}), glm::dvec3{1, 2, 3}), 0.0, 1e-12);
}

TEST(JawMotion, OpensDownward) {
  // By hand: a point 90 mm before the axis, turned by 10 degrees, falls by 90 sin 10 = 15.63 mm and
  // loses 90 (1 - cos 10) = 1.37 mm in z; the glide adds -0.6 and +2.2 mm.
  const JawMotion jaw{.opening_deg = 10.0, .thrust_mm = 0.0};
  const auto moved = jaw.move({0.0, -36.0, 92.0});
  EXPECT_NEAR(moved.y, -36.0 - 15.628 - 0.6, 1e-3);
  EXPECT_NEAR(moved.z, 92.0 - 1.367 + 2.2, 1e-3);
}

TEST(JawMotion, IsUndoneExactly) {
  const JawMotion jaw{.opening_deg = 14.0, .thrust_mm = 3.0};
  const glm::dvec3 point{12.0, -80.0, 85.0};
  EXPECT_NEAR(glm::distance(jaw.undo(jaw.move(point)), point), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(jaw.rigid().move(point), jaw.move(point)), 0.0, 1e-12);
  EXPECT_EQ(jaw.move(point, 0.0), point);
}

TEST(DentalArch, KnowsItsWidthAtEachDepth) {
  EXPECT_DOUBLE_EQ(kUpperArch.z_at(0.0), 93.0);
  EXPECT_DOUBLE_EQ(kUpperArch.z_at(26.0), 65.0);
  EXPECT_NEAR(kLowerArch.half_width_at(kLowerArch.z_at(17.0)), 17.0, 1e-9);
  EXPECT_EQ(kLowerArch.half_width_at(95.0), 0.0);
}

TEST(Smoothing, InterpolatesBetweenAndStaysLevelBeyond) {
  constexpr std::array<double, 3> kX{0.0, 1.0, 3.0};
  constexpr std::array<double, 3> kY{5.0, 7.0, -1.0};
  EXPECT_DOUBLE_EQ(interpolate(-2.0, kX, kY), 5.0);
  EXPECT_DOUBLE_EQ(interpolate(0.5, kX, kY), 6.0);
  EXPECT_DOUBLE_EQ(interpolate(2.0, kX, kY), 3.0);
  EXPECT_DOUBLE_EQ(interpolate(9.0, kX, kY), -1.0);
  EXPECT_DOUBLE_EQ(smooth_step(2.0, 4.0, 3.0), 0.5);
  EXPECT_DOUBLE_EQ(smooth_step(4.0, 2.0, 1.0), 1.0);
}

TEST(Tongue, RestsWhereTheGeneratorPutIt) {
  const auto file = asset("synth/assets/head/head.obj");
  const auto expected = part(read_obj(file), "tongue", file).vertices;
  const auto cage = tongue_cage(neutral_pose(), {});
  ASSERT_EQ(expected.size(), cage.size());
  for (std::size_t i = 0; i < cage.size(); ++i) {
    EXPECT_LT(glm::distance(cage[i], expected[i]), 2e-4) << "vertex " << i;
  }
}

TEST(Tongue, PutsItsTipWhereTheSegmentNeedsIt) {
  // Tip (y, z) from the same independent program as the lips' measures.
  struct Tip {
    Pose pose;
    double y;
    double z;
  };

  const std::vector<Tip> tips{
      {neutral_pose(), -80.836, 85.472},
      {pose_of({{Jaw, 5},
                {TongueLength, 6.5},
                {TongueAngle, 10},
                {TongueTip, 11.5},
                {TongueThickness, 0.9}}),
       -68.015,
       84.923},
      {pose_of({{Jaw, 7}, {TongueLength, -6}, {TongueBack, 16}}), -90.415, 74.943},
      {pose_of({{Jaw, 4}, {TongueLength, -6}, {TongueAngle, 8}, {TongueTip, 4}}), -77.197, 75.178}};
  for (const auto& [pose, y, z] : tips) {
    const auto tip = tongue_cage(pose, {.opening_deg = value(pose, Jaw), .thrust_mm = 0}).back();
    EXPECT_NEAR(tip.y, y, 0.002);
    EXPECT_NEAR(tip.z, z, 0.002);
  }
}

TEST(Tongue, ComesOutBetweenTheTeethOfAnyJawThatIsOpen) {
  for (const double opening : {3.0, 4.0, 6.0, 9.0}) {
    const auto pose = pose_of({{Jaw, opening}, {TongueLength, 15}, {TongueAngle, 8}});
    const JawMotion jaw{.opening_deg = opening, .thrust_mm = 0};
    const auto tip = tongue_cage(pose, jaw).back();
    EXPECT_GT(tip.z, 93.0) << opening;
    EXPECT_LT(tip.y, -78.0) << opening;
    EXPECT_GT(tip.y, jaw.move({0.0, -75.6, 90.0}).y) << opening;
  }
}

TEST(Tongue, StaysBehindTeethThatAreShut) {
  const auto pose = pose_of({{TongueLength, 15}, {TongueAngle, 8}});
  EXPECT_LT(tongue_cage(pose, {}).back().z, 90.0);
}

TEST(Lids, CloseOverTheWholeEye) {
  const FieldTable table{asset("synth/assets/head/fields.csv")};
  const auto ring = table.whole_numbers("eye_ring");
  const auto column = table.whole_numbers("eye_column");
  const auto head = posed(pose_of({{LidClosure, 1.0}}));
  constexpr int kFrontEdge = 4;
  // Column e of the upper lid faces column (36 - e) mod 20 of the lower.
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (ring[i] != kFrontEdge) continue;
    for (std::size_t j = 0; j < table.rows(); ++j) {
      const bool facing = ring[j] == kFrontEdge && column[j] == (36 - column[i]) % 20 &&
                          head.skin_cage[i].x * head.skin_cage[j].x > 0.0;
      if (!facing) continue;
      EXPECT_NEAR(head.skin_cage[i].y, head.skin_cage[j].y, 0.7) << column[i];
    }
  }
}

TEST(Lids, CloseTheRightEyeAlone) {
  const auto open = posed(neutral_pose()).skin_cage;
  const auto wink = posed(pose_of({{RightLidClosure, 1.0}})).skin_cage;
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (open[i].x < 0.0) continue;
    EXPECT_EQ(open[i], wink[i]);
  }
  EXPECT_NE(open, wink);
}

TEST(Lids, LieOutsideTheEyeballHoweverFarTheyClose) {
  constexpr double kSunkMm =
      0.02;  // the lid's margin between its open shape and the sliding sphere
  const FieldTable table{asset("synth/assets/head/fields.csv")};
  const auto ring = table.whole_numbers("eye_ring");
  for (const double closure : {-0.25, 0.0, 0.3, 0.6, 1.0}) {
    const auto head = posed(pose_of({{LidClosure, closure}}));
    for (std::size_t i = 0; i < table.rows(); ++i) {
      if (ring[i] < 3 || ring[i] > 5) continue;
      auto point = head.skin_cage[i];
      point.x = std::abs(point.x);
      EXPECT_GT(glm::distance(point, kLeftEyeCentre), kEyeRadius - kSunkMm)
          << "closure " << closure;
    }
  }
}

TEST(LowerLipTuck, TouchesTheUpperIncisorsWhateverTheJawDoes) {
  const FieldTable table{asset("synth/assets/head/fields.csv")};
  const auto ring = table.whole_numbers("mouth_ring");
  const auto column = table.whole_numbers("mouth_column");
  for (const double jaw : {1.0, 3.0, 6.0, 9.0}) {
    const auto head = posed(pose_of({{Jaw, jaw}, {LowerLipTuck, 1.0}, {UpperLipRaise, 2.0}}));
    for (std::size_t i = 0; i < table.rows(); ++i) {
      if (ring[i] != 6 || column[i] != 16) continue;
      EXPECT_NEAR(head.skin_cage[i].y, -76.4, 0.3) << "jaw " << jaw;
      EXPECT_NEAR(head.skin_cage[i].z, 94.25, 0.5) << "jaw " << jaw;
    }
  }
}

}  // namespace
}  // namespace bimodal::synth
