#include "synth/face/lip_measures.hpp"

#include <ostream>

#include <gtest/gtest.h>

#include "tests/synth/face/the_head.hpp"

namespace bimodal::synth {
namespace {

using enum Control;

// The lips of fourteen segments as an independent program (numpy and scipy) measured them on its
// own subdivision of the same cage. It sampled the opening at 400 places, hence the tolerance of
// its width; and it drew the lips together only once they overlapped, where ours do so over the
// last 1.5 mm, so that they part without a jump: narrow openings end up to 0.25 mm farther out on
// each side, and areas differ by up to 0.6 mm2.
struct Viseme {
  std::string_view name;
  std::vector<Setting> settings;
  double inner_height;
  double inner_width;
  double inner_area;
  double outer_width;
  double outer_height;
  double upper_protrusion;
  double lower_protrusion;
  double chin_drop;
};

void PrintTo(const Viseme& viseme, std::ostream* out) {
  *out << viseme.name;
}

const std::vector<Viseme> kVisemes{
    {"rest", {}, 0.000, 0.000, 0.000, 51.528, 17.758, 0.000, 0.000, 0.0},
    {"i",
     {{Jaw, 3.2}, {LipWidth, 8}, {UpperLipRaise, 1.2}, {LowerLipRaise, -1}, {CornerY, 0.8}},
     7.209,
     55.269,
     333.720,
     59.452,
     22.066,
     -0.144,
     -2.391,
     4.847},
    {"ae",
     {{Jaw, 9}, {LipWidth, 5}, {UpperLipRaise, 1.6}, {LowerLipRaise, -0.8}},
     16.056,
     52.156,
     712.979,
     55.475,
     32.459,
     0.163,
     -7.036,
     12.928},
    {"aa",
     {{Jaw, 11.5}, {LipWidth, -2}, {UpperLipRaise, 0.6}},
     17.815,
     45.019,
     668.923,
     47.936,
     36.568,
     0.663,
     -8.870,
     16.132},
    {"u",
     {{Jaw, 4.5},
      {LipProtrusion, 6.5},
      {LipWidth, -17},
      {LipFunnel, 0.35},
      {LowerLipRaise, 1},
      {UpperLipRaise, -1.2}},
     5.495,
     21.977,
     85.757,
     31.699,
     27.085,
     8.074,
     4.463,
     6.554},
    {"w",
     {{Jaw, 3.2},
      {LipProtrusion, 7.5},
      {LipWidth, -20},
      {LipFunnel, 0.1},
      {LowerLipRaise, 1.8},
      {UpperLipRaise, -0.6}},
     3.083,
     19.159,
     45.534,
     28.410,
     23.690,
     9.143,
     7.381,
     4.605},
    {"b",
     {{Jaw, 2}, {LipClosure, 1}, {LipCompression, 0.55}},
     0.000,
     0.000,
     0.000,
     51.033,
     14.700,
     -0.173,
     -0.624,
     2.998},
    {"f",
     {{Jaw, 3}, {LowerLipTuck, 1}, {UpperLipRaise, 1.8}, {LipWidth, 1}},
     3.641,
     48.933,
     170.436,
     51.808,
     17.906,
     0.233,
     -4.425,
     4.467},
    {"th",
     {{Jaw, 5},
      {LipWidth, 1},
      {UpperLipRaise, 1},
      {LowerLipRaise, -1},
      {TongueLength, 15},
      {TongueAngle, 8},
      {TongueTip, 1.8},
      {TongueThickness, 0.8}},
     9.763,
     48.908,
     411.413,
     52.199,
     27.510,
     0.198,
     -3.757,
     7.438},
    {"t",
     {{Jaw, 5},
      {LipWidth, 1},
      {UpperLipRaise, 1},
      {LowerLipRaise, -1},
      {TongueLength, 6.5},
      {TongueAngle, 10},
      {TongueTip, 11.5},
      {TongueThickness, 0.9}},
     9.763,
     48.908,
     411.413,
     52.199,
     27.510,
     0.198,
     -3.757,
     7.438},
    {"l",
     {{Jaw, 7}, {UpperLipRaise, 1}, {LowerLipRaise, -0.5}},
     12.260,
     47.691,
     510.293,
     50.836,
     30.540,
     0.330,
     -5.241,
     10.191},
    {"sh",
     {{Jaw, 2.6},
      {LipProtrusion, 4.5},
      {LipWidth, -8},
      {LipFunnel, 0.8},
      {UpperLipRaise, 1.2},
      {LowerLipRaise, -1.2}},
     7.140,
     39.110,
     184.243,
     42.242,
     29.770,
     5.030,
     2.682,
     3.996},
    {"r",
     {{Jaw, 4}, {LipProtrusion, 3.5}, {LipWidth, -10}, {LipFunnel, 0.6}},
     6.825,
     37.127,
     160.148,
     40.087,
     28.806,
     4.176,
     0.631,
     5.923},
    {"k",
     {{Jaw, 7}, {LipWidth, 2}, {UpperLipRaise, 0.6}, {TongueBack, 16}, {TongueLength, -6}},
     11.366,
     49.628,
     491.443,
     52.843,
     28.848,
     0.145,
     -5.167,
     10.145},
};

Pose pose_of(const Viseme& viseme) {
  Pose pose = neutral_pose();
  for (const auto& [control, amount] : viseme.settings) value(pose, control) = amount;
  return pose;
}

class Visemes : public testing::TestWithParam<Viseme> {};

TEST_P(Visemes, MeasureAsTheIndependentModelSays) {
  const auto& expected = GetParam();
  const auto lips = posed(pose_of(expected)).lips;
  constexpr double kTolerance = 0.005;
  EXPECT_NEAR(lips.inner_height_mm, expected.inner_height, kTolerance);
  EXPECT_NEAR(lips.inner_width_mm, expected.inner_width, expected.inner_width < 30 ? 0.8 : 0.15);
  EXPECT_NEAR(lips.inner_area_mm2, expected.inner_area, 1.0);
  EXPECT_NEAR(lips.outer_width_mm, expected.outer_width, kTolerance);
  EXPECT_NEAR(lips.outer_height_mm, expected.outer_height, kTolerance);
  EXPECT_NEAR(lips.upper_protrusion_mm, expected.upper_protrusion, kTolerance);
  EXPECT_NEAR(lips.lower_protrusion_mm, expected.lower_protrusion, kTolerance);
  constexpr double kFoldedChin = 0.05;  // mm: the furrow above the chin is not in that model
  EXPECT_NEAR(lips.chin_drop_mm, expected.chin_drop, kFoldedChin);
}

INSTANTIATE_TEST_SUITE_P(Segments, Visemes, testing::ValuesIn(kVisemes), [](const auto& viseme) {
  return std::string{viseme.param.name};
});

TEST(LipMeasures, OfClosedLipsAreExactlyZero) {
  for (const double jaw : {0.0, 2.0, 6.0, 12.0}) {
    const auto lips = posed(synth::pose_of({{Jaw, jaw}, {LipClosure, 1.0}})).lips;
    EXPECT_EQ(lips.inner_height_mm, 0.0) << "jaw " << jaw;
    EXPECT_EQ(lips.inner_width_mm, 0.0) << "jaw " << jaw;
    EXPECT_EQ(lips.inner_area_mm2, 0.0) << "jaw " << jaw;
  }
}

TEST(LipMeasures, GrowWithTheJaw) {
  double height = 0.0;
  double area = 0.0;
  double drop = 0.0;
  for (const double jaw : {2.0, 5.0, 10.0, 15.0, 20.0}) {
    const auto lips = posed(synth::pose_of({{Jaw, jaw}})).lips;
    EXPECT_GT(lips.inner_height_mm, height);
    EXPECT_GT(lips.inner_area_mm2, area);
    EXPECT_GT(lips.chin_drop_mm, drop);
    height = lips.inner_height_mm;
    area = lips.inner_area_mm2;
    drop = lips.chin_drop_mm;
  }
}

TEST(LipMeasures, DoNotChangeWhenTheHeadTurnsButTheCentreDoes) {
  const auto straight = posed(synth::pose_of({{Jaw, 8}})).lips;
  const auto turned = posed(synth::pose_of({{Jaw, 8}, {HeadYaw, 30}, {HeadPitch, 10}})).lips;
  EXPECT_EQ(straight.inner_height_mm, turned.inner_height_mm);
  EXPECT_EQ(straight.inner_area_mm2, turned.inner_area_mm2);
  EXPECT_EQ(straight.outer_width_mm, turned.outer_width_mm);
  EXPECT_EQ(straight.chin_drop_mm, turned.chin_drop_mm);
  EXPECT_GT(turned.inner_centre.x, straight.inner_centre.x + 10.0F);
}

}  // namespace
}  // namespace bimodal::synth
