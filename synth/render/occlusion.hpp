#pragma once

#include <span>
#include <vector>

#include "synth/face/surface.hpp"
#include "synth/render/mesh_buffers.hpp"

namespace bimodal::synth {

/// How much light the resting head lets reach one of its own vertices, each 0..1.
struct Exposure {
  float sky = 1.0F;   ///< part of a sky that is brighter above than below
  float key = 1.0F;   ///< part of the key light, with a soft edge
  float fill = 1.0F;  ///< part of the fill light, with a softer edge
};

/// One per drawn vertex, from depth maps of the head seen from 48 directions of the
/// sky and from both lights; the lights' shadows are then spread over neighbouring vertices, so
/// that no edge of a shadow is sharper than the mesh can show. `mesh` must stand at `resting`.
/// Changes the current framebuffer and viewport.
[[nodiscard]] std::vector<Exposure> exposure_at_rest(const PosedHead& resting,
                                                     const MeshBuffers& mesh,
                                                     const DrawnMesh& drawn,
                                                     const Materials& materials);

}  // namespace bimodal::synth
