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

}  // namespace
}  // namespace bimodal::synth
