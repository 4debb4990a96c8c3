#include "synth/render/camera.hpp"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace bimodal::synth {

namespace {

constexpr float kDistance = 1100.0F;   // mm, from the head's centre
constexpr float kHeadCentreZ = 12.0F;  // mm before the ear canals; the axis of the camera's turn
constexpr float kHalfDepth = 300.0F;   // mm, what lies before and behind the centre

}  // namespace

glm::vec3 towards_camera(const View& view) {
  const auto yaw = static_cast<float>(glm::radians(view.yaw_deg));
  const auto pitch = static_cast<float>(glm::radians(view.pitch_deg));
  return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
}

Camera camera_for(const View& view) {
  const glm::vec3 centre{0.0F, static_cast<float>(view.centre_y_mm), kHeadCentreZ};
  const glm::vec3 position = centre + kDistance * towards_camera(view);
  const glm::mat4 camera_from_world = glm::lookAt(position, centre, glm::vec3{0.0F, 1.0F, 0.0F});

  const float near = kDistance - kHalfDepth;
  const float far = kDistance + kHalfDepth;
  const float half_height = 0.5F * static_cast<float>(view.field_mm) * near / kDistance;
  const float half_width =
      half_height * static_cast<float>(view.width) / static_cast<float>(view.height);
  const glm::mat4 clip_from_camera =
      glm::frustum(-half_width, half_width, half_height, -half_height, near, far);
  return {clip_from_camera * camera_from_world, position};
}

}  // namespace bimodal::synth
