#include "synth/inspection/mouth_measures.hpp"

#include <gtest/gtest.h>

#include "tests/synth/face/the_head.hpp"

namespace bimodal::synth {
namespace {

using enum Control;

class MouthRulers : public testing::Test {
 protected:
  MouthRuler ruler_{the_head()};
};

TEST_F(MouthRulers, SeeNothingOfAShutMouth) {
  const auto mouth = ruler_.measure(neutral_pose());
  EXPECT_EQ(mouth.lips.largest_gap_mm, 0);
  EXPECT_EQ(mouth.seen.upper_teeth_mm2, 0);
  EXPECT_EQ(mouth.seen.tongue_mm2, 0);
  EXPECT_EQ(ruler_.penetrations().worst(), 0);
}

TEST_F(MouthRulers, SeeUpperTeethAndContactOfAnF) {
  const auto mouth =
      ruler_.measure(pose_of({{Jaw, 3}, {LowerLipTuck, 1}, {UpperLipRaise, 1.8}, {LipWidth, 1}}));
  EXPECT_LT(mouth.lip_to_incisors_mm, 0.3);
  EXPECT_GT(mouth.lip_to_incisors_mm, -0.2);
  // Between the lips, 3.6 mm apart and 49 wide, hardly anything but upper teeth is seen.
  EXPECT_GT(mouth.seen.upper_teeth_mm2, 80);
  EXPECT_LT(mouth.seen.upper_teeth_mm2, mouth.lips.inner_area_mm2);
  EXPECT_LT(mouth.seen.lower_teeth_mm2, 1);
}

TEST_F(MouthRulers, SeeNoMoreThanTheOpening) {
  for (const double jaw : {4.0, 8.0, 14.0}) {
    const auto mouth = ruler_.measure(pose_of({{Jaw, jaw}}));
    const auto& seen = mouth.seen;
    EXPECT_LT(seen.upper_teeth_mm2 + seen.lower_teeth_mm2 + seen.tongue_mm2,
              1.1 * mouth.lips.inner_area_mm2)
        << jaw;
  }
}

TEST_F(MouthRulers, SeeTheTongueBetweenTheTeethOnlyWhereItComesOut) {
  const auto out = ruler_.measure(pose_of({{Jaw, 5}, {TongueLength, 15}, {TongueAngle, 8}}));
  EXPECT_GT(out.seen.tongue_between_teeth_mm2, 20);
  const auto back = ruler_.measure(pose_of({{Jaw, 5}, {TongueLength, -6}}));
  EXPECT_EQ(back.seen.tongue_between_teeth_mm2, 0);
  EXPECT_GT(back.seen.tongue_mm2, 20);
}

TEST_F(MouthRulers, FeelTheTipAtTheRidge) {
  const auto touching =
      ruler_.measure(pose_of({{Jaw, 5}, {TongueLength, 7}, {TongueAngle, 11}, {TongueTip, 14}}));
  EXPECT_LT(touching.tongue.to_ridge_mm, 0.5);
  const auto low = ruler_.measure(pose_of({{Jaw, 5}}));
  EXPECT_GT(low.tongue.to_ridge_mm, 8);
}

TEST_F(MouthRulers, FeelMoreRoomBesideANarrowBlade) {
  const Pose wide = pose_of({{Jaw, 5}, {TongueLength, 7}, {TongueAngle, 11}, {TongueTip, 14}});
  Pose narrow = wide;
  value(narrow, TongueWidth) = 0.76;
  EXPECT_GT(ruler_.measure(narrow).tongue.beside_mm, ruler_.measure(wide).tongue.beside_mm + 1.5);
}

TEST_F(MouthRulers, LeaveOutTheHeadsTurning) {
  const Pose ahead = pose_of({{Jaw, 6}});
  Pose turned = ahead;
  value(turned, HeadYaw) = 40;
  EXPECT_EQ(ruler_.measure(ahead).seen.tongue_mm2, ruler_.measure(turned).seen.tongue_mm2);
}

TEST_F(MouthRulers, FollowTheTeethThatAreMoved) {
  const auto moved = ruler_.measure(pose_of({{Jaw, 4}, {TeethZ, 2}, {TeethX, 1}}));
  EXPECT_LT(ruler_.penetrations().tongue_in_teeth, 0.2);
  EXPECT_GT(moved.seen.upper_teeth_mm2, 5);
}

TEST_F(MouthRulers, FindLipsThatArePushedIntoTheTeeth) {
  ruler_.take(pose_of({{LipProtrusion, -2}, {TeethZ, 3}}));
  EXPECT_GT(ruler_.penetrations().flesh_in_teeth, 0.5);
}

}  // namespace
}  // namespace bimodal::synth
