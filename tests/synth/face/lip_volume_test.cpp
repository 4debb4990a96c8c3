// The volume of the lips, measured on the drawn mesh as that of a closed body.
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "synth/face/field_table.hpp"
#include "synth/face/mouth_loops.hpp"
#include "synth/face/obj_reader.hpp"
#include "tests/synth/face/the_head.hpp"

namespace bimodal::synth {
namespace {

using enum Control;

/// A ring round the mouth: vermilion and inner side, closed by a sheet between the white roll and
/// the innermost ring.
class LipBody {
 public:
  LipBody() {
    const FieldTable table{asset("synth/assets/head/fields.csv")};
    const auto file = asset("synth/assets/head/head.obj");
    std::vector<double> x;
    const auto cages = read_obj(file);
    for (const auto& vertex : part(cages, "skin", file).vertices) x.push_back(vertex.x);
    const MouthLoops mouth{
        table.whole_numbers("mouth_ring"), table.whole_numbers("mouth_column"), x};
    using enum MouthLoops::Side;
    for (int column = 0; column < MouthLoops::kColumns; ++column) add(mouth, column, Left);
    for (int column = MouthLoops::kColumns - 2; column > 0; --column) add(mouth, column, Right);
  }

  /// mm3, by the divergence theorem over the body's triangles.
  [[nodiscard]] double volume(const PosedHead& head) const {
    const auto& drawn = head.at(HeadSurface::Skin).positions;
    const auto at = [&](std::size_t column, std::size_t ring) {
      return glm::dvec3{drawn[sections_[column % sections_.size()][ring % kRings]]};
    };
    double sum = 0.0;
    for (std::size_t i = 0; i < sections_.size(); ++i) {
      for (std::size_t j = 0; j < kRings; ++j) {
        const auto a = at(i, j);
        const auto c = at(i + 1, j + 1);
        sum += glm::dot(a, glm::cross(at(i + 1, j), c)) + glm::dot(a, glm::cross(c, at(i, j + 1)));
      }
    }
    return std::abs(sum) / 6.0;
  }

 private:
  static constexpr int kFirst = 3;
  static constexpr std::size_t kRings = 7;

  void add(const MouthLoops& mouth, int column, MouthLoops::Side side) {
    auto& section = sections_.emplace_back();
    for (int ring = kFirst; ring <= MouthLoops::kLastRing; ++ring) {
      section.push_back(mouth.vertex(ring, column, side));
    }
  }

  std::vector<std::vector<std::size_t>> sections_;
};

/// As part of that at rest.
double volume_of(const Pose& pose) {
  static const LipBody body;
  static const double rest = body.volume(posed(neutral_pose()));
  return body.volume(posed(pose)) / rest;
}

// Without it narrowing by 12 mm costs 17 %, protrusion by 7 mm adds 15 %, and raising the lower lip
// by 7 mm costs 16 %.
TEST(LipVolume, IsKeptByWhatSpeechDoes) {
  EXPECT_NEAR(volume_of(pose_of({{LipWidth, -12}})), 1.0, 0.07);
  EXPECT_NEAR(volume_of(pose_of({{LipWidth, 6}})), 1.0, 0.07);
  EXPECT_NEAR(volume_of(pose_of({{LipProtrusion, 7}})), 1.0, 0.07);
  EXPECT_NEAR(volume_of(pose_of({{Jaw, 14}})), 1.0, 0.07);
  EXPECT_NEAR(volume_of(pose_of({{UpperLipRaise, 7}})), 1.0, 0.07);
  EXPECT_NEAR(volume_of(pose_of({{LowerLipRaise, 7}})), 1.0, 0.07);
  EXPECT_NEAR(volume_of(pose_of({{Jaw, 3}, {LowerLipTuck, 1}})), 1.0, 0.07);
  EXPECT_NEAR(volume_of(pose_of({{Jaw, 3}, {LipClosure, 1}, {LipCompression, 0.5}})), 1.0, 0.07);
  EXPECT_NEAR(
      volume_of(pose_of({{LipWidth, -18}, {LipProtrusion, 7}, {LipFunnel, 0.5}})), 1.0, 0.07);
}

TEST(LipVolume, LeavesTheFaceAtRestAlone) {
  const auto head = posed(neutral_pose());
  const auto& drawn = head.at(HeadSurface::Skin).positions;
  const auto& rest = the_head().surfaces().front().rest_positions;
  for (std::size_t i = 0; i < rest.size(); ++i) EXPECT_LT(glm::distance(drawn[i], rest[i]), 1e-3F);
}

}  // namespace
}  // namespace bimodal::synth
