#include "synth/render/camera.hpp"

#include <cassert>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace bimodal::synth {

namespace {

constexpr float kHalfDepth = 300.0F;  // mm, what lies before and behind the centre
constexpr float kParallel = 1e5F;  // mm; an eye from which the head's lines of sight are parallel

}  // namespace

glm::vec3 towards_camera(const View& view) {
  const auto yaw = static_cast<float>(glm::radians(view.yaw_deg));
  const auto pitch = static_cast<float>(glm::radians(view.pitch_deg));
  return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
}

Camera camera_for(const View& view) {
  const glm::vec3 centre{static_cast<float>(view.centre_x_mm),
                         static_cast<float>(view.centre_y_mm),
                         static_cast<float>(view.centre_z_mm)};
  const auto distance = static_cast<float>(view.distance_mm);
  assert(distance >= static_cast<float>(kNearestCamera));
  const glm::vec3 position = centre + distance * towards_camera(view);
  const glm::mat4 camera_from_world = glm::lookAt(position, centre, glm::vec3{0.0F, 1.0F, 0.0F});

  const float near = distance - kHalfDepth;
  const float far = distance + kHalfDepth;
  const bool is_parallel = view.projection == Projection::Orthographic;
  const auto field = static_cast<float>(view.field_mm);
  const float half_height = is_parallel ? 0.5F * field : 0.5F * field * near / distance;
  const float half_width =
      half_height * static_cast<float>(view.width) / static_cast<float>(view.height);
  if (is_parallel) {
    const glm::mat4 clip_from_camera =
        glm::ortho(-half_width, half_width, half_height, -half_height, near, far);
    return {clip_from_camera * camera_from_world, centre + kParallel * towards_camera(view)};
  }
  const glm::mat4 clip_from_camera =
      glm::frustum(-half_width, half_width, half_height, -half_height, near, far);
  return {clip_from_camera * camera_from_world, position};
}

}  // namespace bimodal::synth
