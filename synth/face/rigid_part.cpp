#include "synth/face/rigid_part.hpp"

#include <utility>

#include <glm/mat3x3.hpp>

#include "synth/face/quad_normals.hpp"

namespace bimodal::synth {

void RigidPart::move(const RigidMotion& motion, SurfaceGeometry& moved) const {
  const auto count = at_rest.positions.size();
  moved.positions.resize(count);
  moved.normals.resize(count);
  const glm::mat3 rotation{motion.rotation};
  const glm::vec3 translation{motion.translation};
  for (std::size_t i = 0; i < count; ++i) {
    moved.positions[i] = rotation * at_rest.positions[i] + translation;
    moved.normals[i] = rotation * at_rest.normals[i];
  }
}

RigidPart rigid_part(const Cage& cage,
                     const Stencils& stencils,
                     Material material,
                     RigidPart::Carrier carrier) {
  RigidPart part{.carrier = carrier, .description = {}, .at_rest = {}};
  stencils.apply(cage.vertices, part.at_rest.positions);
  quad_normals(part.at_rest.positions, stencils.quads(), part.at_rest.normals);
  part.description = unmasked(material, stencils.triangles(), part.at_rest.positions);
  part.description.name = cage.name;
  return part;
}

SurfaceDescription unmasked(Material material,
                            std::vector<std::uint32_t> triangles,
                            std::vector<glm::vec3> rest_positions) {
  const auto count = rest_positions.size();
  return {.material = material,
          .triangles = std::move(triangles),
          .rest_positions = std::move(rest_positions),
          .lip = std::vector<float>(count),
          .wet = std::vector<float>(count),
          .scalp = std::vector<float>(count),
          .lower = std::vector<float>(count),
          .special = std::vector<float>(count)};
}

}  // namespace bimodal::synth
