#include "synth/render/quality.hpp"

#include <cmath>
#include <string>

#include "tests/synth/render/drawn_head.hpp"

namespace bimodal::synth {
namespace {

using enum Control;

class DrawnInFull : public Drawing {
 protected:
  static View mouth() {
    return {.width = 160, .height = 160, .centre_y_mm = -76.0, .field_mm = 80.0};
  }

  static Appearance full() {
    Appearance appearance;
    appearance.quality = Quality::Full;
    return appearance;
  }

  /// Mean over pixels and colours, of 255.
  static double mean_difference(const Image& one, const Image& other) {
    double sum = 0.0;
    for (std::size_t i = 0; i < one.pixels.size(); ++i) {
      sum += std::abs(static_cast<double>(one.pixels[i]) - other.pixels[i]);
    }
    return sum * 4.0 / 3.0 / static_cast<double>(one.pixels.size());
  }
};

// Measured: 1.5 at rest, 2.2 open, 1.8 rounded, 1.3 for f; nearly all of it is in shadows.
TEST_F(DrawnInFull, ShowsTheSameMouthAsFast) {
  constexpr double kMostLevels = 2.5;  // of 255, mean over the region of the mouth
  int number = 0;
  for (const Pose& pose : {neutral_pose(),
                           pose_of({{Jaw, 10.0}, {UpperLipRaise, 2.0}}),
                           pose_of({{Jaw, 4.0}, {LipWidth, -16.0}, {LipProtrusion, 7.0}}),
                           pose_of({{Jaw, 3.0}, {LowerLipTuck, 1.0}})}) {
    const double difference =
        mean_difference(drawn(pose, mouth(), {}), drawn(pose, mouth(), full()));
    RecordProperty("levels_" + std::to_string(++number), std::to_string(difference));
    EXPECT_LT(difference, kMostLevels);
    EXPECT_GT(difference, 0.0);
  }
}

TEST_F(DrawnInFull, TheChinsShadowFollowsTheJaw) {
  const View throat{.width = 120, .height = 120, .centre_y_mm = -140.0, .field_mm = 80.0};
  const auto change = [&](const Appearance& appearance) {
    const Image shut = drawn(pose_of({{CheekPuff, 0.0}}), throat, appearance);
    const Image thrust = drawn(pose_of({{JawThrust, 6.0}}), throat, appearance);
    return mean_difference(shut, thrust);
  };
  EXPECT_GT(change(full()), 1.2 * change({}));
}

TEST_F(DrawnInFull, IsTheSameBytesForTheSamePose) {
  EXPECT_EQ(drawn(neutral_pose(), mouth(), full()).pixels,
            drawn(neutral_pose(), mouth(), full()).pixels);
}

TEST_F(DrawnInFull, MayTakeFourSamplesAPixel) {
  Appearance fine = full();
  fine.samples = 4;
  const Pose open = pose_of({{Jaw, 10.0}});
  const double difference =
      mean_difference(drawn(open, mouth(), full()), drawn(open, mouth(), fine));
  EXPECT_GT(difference, 0.05);
  EXPECT_LT(difference, 2.0) << "another face";
}

}  // namespace
}  // namespace bimodal::synth
