#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "synth/render/view.hpp"

namespace bimodal::synth {

struct Camera {
  glm::mat4 clip_from_world;  ///< with the y axis down: OpenGL's first row is the picture's top
  glm::vec3 position;         ///< mm, in the head's coordinates; very far if orthographic
};

/// From the head's centre, unit length.
[[nodiscard]] glm::vec3 towards_camera(const View& view);

[[nodiscard]] Camera camera_for(const View& view);

}  // namespace bimodal::synth
