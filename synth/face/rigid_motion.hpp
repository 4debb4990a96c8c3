#pragma once

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

namespace bimodal::synth {

/// point -> rotation * point + translation, mm.
struct RigidMotion {
  glm::dmat3 rotation{1.0};
  glm::dvec3 translation{0.0};

  [[nodiscard]] glm::dvec3 move(const glm::dvec3& point) const {
    return rotation * point + translation;
  }

  /// First `first`, then this.
  [[nodiscard]] RigidMotion after(const RigidMotion& first) const {
    return {rotation * first.rotation, move(first.translation)};
  }

  /// Brings back what this moved.
  [[nodiscard]] RigidMotion inverse() const {
    const glm::dmat3 back = glm::transpose(rotation);
    return {back, -(back * translation)};
  }

  bool operator==(const RigidMotion& other) const = default;
};

/// Rotations by degrees about the axes, right-handed: about x, +z goes to -y (down); about y, +z
/// goes to +x (the subject's left); about z, +x goes to +y.
[[nodiscard]] glm::dmat3 rotation_about_x(double degrees);
[[nodiscard]] glm::dmat3 rotation_about_y(double degrees);
[[nodiscard]] glm::dmat3 rotation_about_z(double degrees);

[[nodiscard]] RigidMotion rotation_about(const glm::dvec3& centre, const glm::dmat3& rotation);

}  // namespace bimodal::synth
