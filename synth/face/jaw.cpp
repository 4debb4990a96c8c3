#include "synth/face/jaw.hpp"

namespace bimodal::synth {

namespace {

constexpr glm::dvec3 kAxis{0.0, -36.0, 2.0};
constexpr glm::dvec3 kGlidePerDegree{0.0, -0.06, 0.22};

}  // namespace

glm::dvec3 JawMotion::translation() const {
  return glm::dvec3{0.0, 0.0, thrust_mm} + kGlidePerDegree * opening_deg;
}

glm::dvec3 JawMotion::move(const glm::dvec3& point, double weight) const {
  return kAxis + rotation_about_x(opening_deg * weight) * (point - kAxis) + translation() * weight;
}

glm::dvec3 JawMotion::undo(const glm::dvec3& point) const {
  return kAxis + rotation_about_x(-opening_deg) * (point - translation() - kAxis);
}

RigidMotion JawMotion::rigid(double weight) const {
  auto motion = rotation_about(kAxis, rotation_about_x(opening_deg * weight));
  motion.translation += translation() * weight;
  return motion;
}

}  // namespace bimodal::synth
