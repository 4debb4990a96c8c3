#pragma once

#include <glm/vec3.hpp>

#include "synth/face/rigid_motion.hpp"

namespace bimodal::synth {

/// The lower jaw: rotation about an axis in the ramus (the mean axis of speech-sized movements lies
/// well below the condyle), the condyle's glide down and forward in step with it, and thrust.
struct JawMotion {
  double opening_deg = 0.0;
  double thrust_mm = 0.0;

  /// `weight` is the part of the movement that a vertex shares; 1 for the teeth.
  [[nodiscard]] glm::dvec3 move(const glm::dvec3& point, double weight = 1.0) const;

  /// Where a point that moved with weight 1 came from.
  [[nodiscard]] glm::dvec3 undo(const glm::dvec3& point) const;

  /// move() for many points of one weight.
  [[nodiscard]] RigidMotion rigid(double weight = 1.0) const;

 private:
  [[nodiscard]] glm::dvec3 translation() const;
};

}  // namespace bimodal::synth
