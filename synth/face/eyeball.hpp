#pragma once

#include <cmath>

#include <glm/vec3.hpp>

namespace bimodal::synth {

inline constexpr glm::dvec3 kLeftEyeCentre{31.2, 0.0, 71.0};  ///< the right one at -x
inline constexpr double kEyeRadius = 12.4;                    ///< mm

/// Height (z) above the eye's centre, `away` mm from the gaze's axis, of a sphere of `radius`,
/// continued along its tangent from 0.8 radius outward, because the corners of the eye lie off the
/// ball.
inline double height_round_eye(double away, double radius) {
  constexpr double kTangentFrom = 0.8;
  constexpr double kTangentHeight = 0.6;  // sqrt(1 - 0.8^2)
  if (away < kTangentFrom * radius) return std::sqrt(radius * radius - away * away);
  return radius * kTangentHeight - kTangentFrom / kTangentHeight * (away - kTangentFrom * radius);
}

}  // namespace bimodal::synth
