#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "synth/face/obj_reader.hpp"
#include "synth/face/rigid_motion.hpp"
#include "synth/face/stencils.hpp"
#include "synth/face/surface.hpp"

namespace bimodal::synth {

/// A surface that only turns and shifts: subdivided once, moved as a whole with every frame.
/// (Subdivision commutes with affine motion.)
struct RigidPart {
  /// What carries it, besides the head.
  enum class Carrier : std::uint8_t { Head, UpperTeeth, LowerTeeth, LeftEye, RightEye };

  Carrier carrier = Carrier::Head;
  SurfaceDescription description;
  SurfaceGeometry at_rest;

  void move(const RigidMotion& motion, SurfaceGeometry& moved) const;
};

/// `cage` subdivided by `stencils`; masks are zero, rest positions are the positions.
[[nodiscard]] RigidPart rigid_part(const Cage& cage,
                                   const Stencils& stencils,
                                   Material material,
                                   RigidPart::Carrier carrier);

/// A description whose masks are all zero.
[[nodiscard]] SurfaceDescription unmasked(Material material,
                                          std::vector<std::uint32_t> triangles,
                                          std::vector<glm::vec3> rest_positions);

}  // namespace bimodal::synth
