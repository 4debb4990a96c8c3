#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "synth/face/padded.hpp"
#include "synth/face/stencils.hpp"

namespace bimodal::synth {

/// Area-weighted vertex normals of unit length: the cross products of the quads' diagonals, summed.
void quad_normals(std::span<const glm::vec3> positions,
                  std::span<const Stencils::Quad> quads,
                  std::vector<glm::vec3>& normals);

/// The same. `sums` is scratch, kept from frame to frame.
void quad_normals(std::span<const Padded> positions,
                  std::span<const Stencils::Quad> quads,
                  PaddedPoints& sums,
                  std::vector<glm::vec3>& normals);

}  // namespace bimodal::synth
