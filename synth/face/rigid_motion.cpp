#include "synth/face/rigid_motion.hpp"

#include <cmath>

#include <glm/trigonometric.hpp>

namespace bimodal::synth {

// glm's constructor takes columns.

glm::dmat3 rotation_about_x(double degrees) {
  const double s = std::sin(glm::radians(degrees));
  const double c = std::cos(glm::radians(degrees));
  return {1, 0, 0, 0, c, s, 0, -s, c};
}

glm::dmat3 rotation_about_y(double degrees) {
  const double s = std::sin(glm::radians(degrees));
  const double c = std::cos(glm::radians(degrees));
  return {c, 0, -s, 0, 1, 0, s, 0, c};
}

glm::dmat3 rotation_about_z(double degrees) {
  const double s = std::sin(glm::radians(degrees));
  const double c = std::cos(glm::radians(degrees));
  return {c, s, 0, -s, c, 0, 0, 0, 1};
}

RigidMotion rotation_about(const glm::dvec3& centre, const glm::dmat3& rotation) {
  return {rotation, centre - rotation * centre};
}

}  // namespace bimodal::synth
