#include "synth/render/camera.hpp"

#include <glm/vec4.hpp>
#include <gtest/gtest.h>

namespace bimodal::synth {
namespace {

/// Where a point is drawn: x to the right and y down, each -1..1; z is 1 far away, -1 near.
glm::vec3 drawn_at(const Camera& camera, glm::vec3 point) {
  const glm::vec4 clip = camera.clip_from_world * glm::vec4{point, 1.0F};
  return glm::vec3{clip} / clip.w;
}

constexpr float kHeadCentreZ = 12.0F;

TEST(Camera, ShowsTheAskedFieldAtTheHeadsCentre) {
  View view;
  view.centre_y_mm = -30.0;
  view.field_mm = 270.0;
  view.width = 640;
  view.height = 720;
  const Camera camera = camera_for(view);
  EXPECT_NEAR(drawn_at(camera, {0.0F, -30.0F, kHeadCentreZ}).y, 0.0F, 1e-5F);
  EXPECT_NEAR(drawn_at(camera, {0.0F, 105.0F, kHeadCentreZ}).y, -1.0F, 1e-4F);  // top
  EXPECT_NEAR(drawn_at(camera, {0.0F, -165.0F, kHeadCentreZ}).y, 1.0F, 1e-4F);
  EXPECT_NEAR(
      drawn_at(camera, {120.0F, -30.0F, kHeadCentreZ}).x, 1.0F, 1e-4F);  // 270 * 640 / 720 / 2
}

TEST(Camera, SeesTheSubjectsLeftOnTheRightFromTheFront) {
  const Camera camera = camera_for(View{});
  EXPECT_GT(drawn_at(camera, {60.0F, 0.0F, 0.0F}).x, 0.0F);
}

TEST(Camera, WithPositiveYawStandsOnTheSubjectsLeft) {
  View view;
  view.yaw_deg = 35.0;
  const Camera camera = camera_for(view);
  EXPECT_GT(camera.position.x, 0.0F);
  EXPECT_LT(drawn_at(camera, {70.0F, 0.0F, 0.0F}).z, drawn_at(camera, {-70.0F, 0.0F, 0.0F}).z);
}

TEST(Camera, WithPositivePitchLooksFromAbove) {
  View view;
  view.pitch_deg = 20.0;
  const Camera camera = camera_for(view);
  EXPECT_LT(drawn_at(camera, {0.0F, 60.0F, 0.0F}).z, drawn_at(camera, {0.0F, -90.0F, 0.0F}).z);
}

TEST(Camera, MayStandNearerOrFarther) {
  View view;
  view.distance_mm = 500.0;
  const Camera camera = camera_for(view);
  EXPECT_NEAR(drawn_at(camera, {0.0F, 105.0F, kHeadCentreZ}).y, -1.0F, 1e-4F);
  EXPECT_LT(drawn_at(camera, {0.0F, 105.0F, 100.0F}).y, -1.1F) << "no stronger perspective";
}

TEST(Camera, OrthographicDrawsTheNearAsLargeAsTheFar) {
  View view;
  view.projection = Projection::Orthographic;
  const Camera camera = camera_for(view);
  for (const float z : {-90.0F, 12.0F, 110.0F}) {
    EXPECT_NEAR(drawn_at(camera, {0.0F, 105.0F, z}).y, -1.0F, 1e-4F);
  }
  EXPECT_LT(drawn_at(camera, {0.0F, 0.0F, 100.0F}).z, drawn_at(camera, {0.0F, 0.0F, 0.0F}).z);
}

TEST(Camera, LooksAtTheAskedCentre) {
  View view;
  view.centre_x_mm = 10.0;
  view.centre_y_mm = -80.0;
  view.centre_z_mm = 60.0;
  view.yaw_deg = 70.0;
  const glm::vec3 drawn = drawn_at(camera_for(view), {10.0F, -80.0F, 60.0F});
  EXPECT_NEAR(drawn.x, 0.0F, 1e-5F);
  EXPECT_NEAR(drawn.y, 0.0F, 1e-5F);
}

}  // namespace
}  // namespace bimodal::synth
