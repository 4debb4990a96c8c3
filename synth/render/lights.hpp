#pragma once

#include <glm/vec3.hpp>

namespace bimodal::synth {

/// Directions towards the lights, unit length, in the room: they stay when the head or the camera
/// turns. A warm key light from the subject's right above, a fill light from the left.
inline constexpr glm::vec3 kKeyDirection{-0.3945F, 0.4109F, 0.8219F};
inline constexpr glm::vec3 kFillDirection{0.6836F, 0.0965F, 0.7238F};

}  // namespace bimodal::synth
