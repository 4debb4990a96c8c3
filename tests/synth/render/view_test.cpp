#include "synth/render/view.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace bimodal::synth {
namespace {

TEST(VisualAngles, AreThoseOfTheFieldFromTheCamera) {
  const View view{.field_mm = 200.0, .distance_mm = 1000.0};
  const auto angles = angles_at_camera(view);
  ASSERT_TRUE(angles.has_value());
  EXPECT_NEAR(angles->picture_deg, 11.421, 0.001);          // 2 atan(0.1)
  EXPECT_NEAR(angles->lip_millimetre_deg, 0.0631, 0.0001);  // the lips are 92 mm nearer
}

TEST(VisualAngles, DoNotExistForParallelLinesOfSight) {
  EXPECT_FALSE(angles_at_camera({.projection = Projection::Orthographic}).has_value());
}

TEST(VisualAngles, OfAParticipantFollowTheScreen) {
  const View parallel{.field_mm = 200.0, .projection = Projection::Orthographic};
  const Screen screen{.viewing_distance_mm = 573.0, .picture_height_mm = 200.0};
  EXPECT_NEAR(angles_on(screen, parallel).picture_deg, 19.8, 0.05);
  EXPECT_NEAR(angles_on(screen, parallel).lip_millimetre_deg, 0.1, 0.0005);  // 1 mm at 573 mm
  const View central{.field_mm = 200.0};
  EXPECT_GT(angles_on(screen, central).lip_millimetre_deg, 0.1) << "lips are nearer than the ears";
}

}  // namespace
}  // namespace bimodal::synth
