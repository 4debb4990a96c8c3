#include "synth/face/head_motion.hpp"

namespace bimodal::synth {

RigidMotion head_motion(const Pose& pose) {
  constexpr glm::dvec3 kAtlas{0.0, -55.0, -18.0};
  return rotation_about(kAtlas,
                        rotation_about_y(value(pose, Control::HeadYaw)) *
                            rotation_about_x(value(pose, Control::HeadPitch)) *
                            rotation_about_z(value(pose, Control::HeadRoll)));
}

void turn_skin(const RigidMotion& head,
               std::span<const float> follow,
               std::span<Padded> positions) {
  const glm::mat3 rotation{head.rotation};
  const glm::vec3 translation{head.translation};
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto point = unpadded(positions[i]);
    positions[i] += follow[i] * padded(rotation * point + translation - point);
  }
}

void turn(const RigidMotion& head, SurfaceGeometry& surface) {
  const glm::mat3 rotation{head.rotation};
  const glm::vec3 translation{head.translation};
  for (auto& point : surface.positions) point = rotation * point + translation;
  for (auto& normal : surface.normals) normal = rotation * normal;
}

}  // namespace bimodal::synth
