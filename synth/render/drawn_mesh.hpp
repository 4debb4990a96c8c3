#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "synth/render/head_parts.hpp"

namespace bimodal::synth {

/// One vertex of one surface.
struct DrawnVertex {
  std::uint32_t surface = 0;  ///< its place in Head::surfaces()
  std::uint32_t own = 0;      ///< the vertex's number there
};

/// What is drawn of all surfaces, part by part. Only vertices that a triangle has are in it, in the
/// order in which drawing meets them: software OpenGL works out most vertices once for each time
/// that it meets them, unless it has met them shortly before under a number near by.
struct DrawnMesh {
  std::vector<DrawnVertex> vertices;
  std::array<PartTriangles, kHeadPartCount> parts;  ///< their indices are places in `vertices`
};

/// As sort_by_part(), whose parameters these are.
[[nodiscard]] DrawnMesh drawn_mesh(std::span<const SurfaceDescription> surfaces,
                                   std::span<const std::vector<VertexPaint>> paints,
                                   const PosedHead& resting,
                                   const glm::vec3& towards_camera,
                                   Quality quality);

}  // namespace bimodal::synth
