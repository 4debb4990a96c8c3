#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "synth/face/padded.hpp"
#include "synth/face/rigid_motion.hpp"

namespace bimodal::synth {

enum class Material : std::uint8_t { Skin, Tooth, Gum, Tongue, Eye, Cornea, Lash };

/// The places of those surfaces of the project's head that are looked for by name, in
/// Head::surfaces() and PosedHead::surfaces; ears, eyes and what belongs to them follow.
enum class HeadSurface : std::uint8_t {
  Skin,
  Tongue,
  Lashes,
  UpperTeeth,
  LowerTeeth,
  UpperGum,
  LowerGum,
  Palate,
};

/// What never changes about one part of the head. Millimetres; x = subject's left, y up, z forward;
/// origin midway between the ear canals at pupil height.
struct SurfaceDescription {
  Material material = Material::Skin;
  std::vector<std::uint32_t> triangles;  ///< three vertex indices each, counter-clockwise outside
  std::vector<glm::vec3>
      rest_positions;  ///< solid texture coordinates; for Eye: unit vector, gaze +z
  std::vector<float>
      lip;  ///< lip mask: 0 skin, 0.5 vermilion border, 1 vermilion, > 1.6 wet inside
  std::vector<float> wet;    ///< 1 in the mouth cavity
  std::vector<float> scalp;  ///< hair mask
  std::vector<float> lower;  ///< in the mouth's loops: 0 the upper lip, 1 the lower; else 0
  std::vector<float>
      special;  ///< Skin: darkness of nostril and lid; Tooth: 0 incisal to 1 cervical
  std::string name =
      {};  ///< of the part in head.obj, e.g. "lower_teeth"; of one made here, "lashes"
};

/// The moving part: as many as the description has rest positions.
struct SurfaceGeometry {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;  ///< unit length
};

/// Lip and jaw measures of a pose, on the drawn mesh (the terms of natural-lips data).
struct LipMeasures {
  double inner_height_mm = 0.0;  ///< opening on the midline; 0 when closed
  double inner_width_mm = 0.0;   ///< width of the opening; 0 when closed
  double inner_area_mm2 = 0.0;
  double outer_width_mm = 0.0;  ///< corner to corner of the vermilion border
  double outer_height_mm = 0.0;
  double upper_protrusion_mm = 0.0;  ///< forward of rest
  double lower_protrusion_mm = 0.0;
  double corner_out_mm = 0.0;      ///< mean of both corners of the vermilion border, from rest
  double corner_up_mm = 0.0;       ///< so too
  double corner_forward_mm = 0.0;  ///< so too
  double chin_drop_mm = 0.0;       ///< below rest
  double largest_gap_mm = 0.0;     ///< along the whole slit; negative parts of gaps do not count
  double smallest_gap_mm = 0.0;    ///< along the whole slit; negative: the lips lie in each other
  glm::vec3 inner_centre{};        ///< centre of the opening, for the light inside the mouth
};

/// What Head::pose() works on and keeps from frame to frame; of no interest to anybody else.
struct PosingMemory {
  PaddedPoints skin_cage;
  PaddedPoints skin;
  PaddedPoints skin_normals;  ///< before they are made unit long
  PaddedPoints tongue;
  PaddedPoints tongue_normals;
  std::shared_ptr<const void> posed_by;  ///< the head whose rigid parts
  std::vector<RigidMotion> motions;      ///< have moved so
};

/// One posed head, written by Head::pose() alone. Reused from frame to frame, so that posing
/// allocates only once.
struct PosedHead {
  std::vector<SurfaceGeometry> surfaces;  ///< parallel to Head::surfaces()
  LipMeasures lips;
  std::vector<glm::dvec3> skin_cage;  ///< the posed control cage of the skin, before the head turns
  PosingMemory memory;

  [[nodiscard]] const SurfaceGeometry& at(HeadSurface name) const {
    return surfaces[static_cast<std::size_t>(name)];
  }
};

}  // namespace bimodal::synth
