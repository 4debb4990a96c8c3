#pragma once

#include <glm/vec3.hpp>

namespace bimodal::synth {

inline constexpr glm::dvec3 kLeftEyeCentre{31.2, 0.0, 71.0};  ///< the right one at -x
inline constexpr double kEyeRadius = 12.4;                    ///< mm

}  // namespace bimodal::synth
