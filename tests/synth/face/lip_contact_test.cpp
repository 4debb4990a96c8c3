#include "synth/face/lip_contact.hpp"

#include <algorithm>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"
#include "synth/face/field_table.hpp"
#include "synth/face/stencils.hpp"
#include "tests/synth/face/the_head.hpp"

namespace bimodal::synth {
namespace {

using enum Control;

/// The lips as drawn, in double precision.
class DrawnLips {
 public:
  DrawnLips()
      : file_{asset("synth/assets/head/head.obj")},
        cage_{part(read_obj(file_), "skin", file_)},
        stencils_{cage_.vertices.size(), cage_.faces, 2},
        table_{asset("synth/assets/head/fields.csv")},
        mouth_{table_.whole_numbers("mouth_ring"), table_.whole_numbers("mouth_column"), x()} {}

  /// Upper minus lower at a pair of facing points, mm.
  [[nodiscard]] glm::dvec3 gap(const PosedHead& head, int ring, int column) const {
    using enum MouthLoops::Side;
    return stencils_.point(head.skin_cage, mouth_.vertex(ring, column, Left)) -
           stencils_.point(head.skin_cage, mouth_.vertex(ring, 16 - column, Left));
  }

 private:
  [[nodiscard]] std::vector<double> x() const {
    std::vector<double> result;
    for (const auto& vertex : cage_.vertices) result.push_back(vertex.x);
    return result;
  }

  std::filesystem::path file_;
  Cage cage_;
  Stencils stencils_;
  FieldTable table_;
  MouthLoops mouth_;
};

const DrawnLips& drawn_lips() {
  static const DrawnLips lips;
  return lips;
}

TEST(LipContact, SealsTheMiddleContactRingOfB) {
  const auto head = posed(pose_of({{Jaw, 2}, {LipClosure, 1}, {LipCompression, 0.55}}));
  for (int column = 0; column < MouthLoops::kCorner; ++column) {
    EXPECT_LT(glm::length(drawn_lips().gap(head, 7, column)), 1e-9) << "column " << column;
  }
}

TEST(LipContact, SealsTheLipsAtRest) {
  const auto head = posed(neutral_pose());
  for (int column = 0; column < MouthLoops::kCorner; ++column) {
    EXPECT_LT(glm::length(drawn_lips().gap(head, 7, column)), 1e-9) << "column " << column;
  }
}

TEST(LipContact, NeverLetsTheLipsPassThroughEachOther) {
  constexpr std::array kMoving{Jaw,
                               JawThrust,
                               LipWidth,
                               LipProtrusion,
                               LipFunnel,
                               UpperLipRaise,
                               LowerLipRaise,
                               CornerX,
                               CornerY,
                               LipClosure,
                               LipCompression,
                               CheekPuff};
  Random random{20};
  double worst = 0.0;
  PosedHead head;
  for (int trial = 0; trial < 300; ++trial) {
    Pose pose = neutral_pose();
    for (const auto control : kMoving) {
      const auto& range = describe(control);
      value(pose, control) =
          0.8 * (range.lowest + (range.highest - range.lowest) * random.uniform());
    }
    the_head().pose(pose, head);
    for (int ring = 6; ring <= 8; ++ring) {
      for (int column = 0; column < MouthLoops::kCorner; ++column) {
        worst = std::min(worst, drawn_lips().gap(head, ring, column).y);
      }
    }
  }
  EXPECT_GT(worst, -1e-9);
}

TEST(LipContact, ZipsNarrowLipsFromTheCorners) {
  const auto narrow = posed(pose_of({{Jaw, 4}, {LipWidth, -16}}));
  const auto wide = posed(pose_of({{Jaw, 4}}));
  EXPECT_NEAR(drawn_lips().gap(narrow, 7, 6).y, 0.0, 1e-9);
  EXPECT_GT(drawn_lips().gap(wide, 7, 6).y, 1.0);
  EXPECT_GT(drawn_lips().gap(narrow, 7, 0).y, 4.0);
}

/// The longest way of any cage vertex in one of `steps` equal steps from one pose to another, mm.
double longest_step(const Pose& from, const Pose& to, int steps) {
  double longest = 0.0;
  PosedHead head;
  std::vector<glm::dvec3> before;
  for (int i = 0; i <= steps; ++i) {
    Pose pose = from;
    for (std::size_t c = 0; c < pose.size(); ++c) pose.at(c) += (to.at(c) - from.at(c)) * i / steps;
    the_head().pose(pose, head);
    for (std::size_t v = 0; v < before.size(); ++v) {
      longest = std::max(longest, glm::distance(before[v], head.skin_cage[v]));
    }
    before = head.skin_cage;
  }
  return longest;
}

TEST(LipContact, PartsAndMeetsWithoutAJump) {
  // Were there a jump, the longest step would not shrink in proportion to the steps.
  struct Way {
    Pose from;
    Pose to;
  };

  const std::vector<Way> ways{
      {pose_of({{LowerLipRaise, 3}}), pose_of({{LowerLipRaise, 3}, {Jaw, 8}})},
      {pose_of({{Jaw, 2}, {LipClosure, 1}, {LipCompression, 0.55}}), pose_of({{Jaw, 11.5}})},
      {pose_of({{Jaw, 2}, {LipClosure, 1}}),
       pose_of({{Jaw, 4.5}, {LipWidth, -17}, {LipProtrusion, 6.5}, {LipFunnel, 0.35}})},
      {pose_of({{LipProtrusion, 6}, {LowerLipRaise, 4}, {JawThrust, 3}}),
       pose_of({{LipProtrusion, 6}, {LowerLipRaise, -4}, {JawThrust, 3}, {Jaw, 3}})},
      {pose_of({{UpperLipRaise, -3}, {LowerLipRaise, 3}, {JawThrust, -4}}),
       pose_of({{LowerLipRaise, -3}, {JawThrust, 6}})}};
  for (const auto& [from, to] : ways) {
    const double coarse = longest_step(from, to, 40);
    const double fine = longest_step(from, to, 400);
    EXPECT_LT(fine, 0.15 * coarse);
  }
}

}  // namespace
}  // namespace bimodal::synth
