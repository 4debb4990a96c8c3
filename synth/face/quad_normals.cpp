#include "synth/face/quad_normals.hpp"

#include <algorithm>
#include <cmath>

namespace bimodal::synth {

namespace {

void add_normals(std::span<const Padded> positions,
                 std::span<const Stencils::Quad> quads,
                 PaddedPoints& sums) {
  sums.assign(positions.size(), Padded{});
  for (const auto& [a, b, c, d] : quads) {
    const Padded normal = cross(positions[c] - positions[a], positions[d] - positions[b]);
    sums[a] += normal;
    sums[b] += normal;
    sums[c] += normal;
    sums[d] += normal;
  }
}

glm::vec3 unit_vector(Padded along) {
  constexpr float kNoArea = 1e-20F;
  const float length = std::sqrt(dot(along, along));
  if (length <= kNoArea) return {0.0F, 0.0F, 1.0F};
  return unpadded(along * (1.0F / length));
}

}  // namespace

void quad_normals(std::span<const glm::vec3> positions,
                  std::span<const Stencils::Quad> quads,
                  std::vector<glm::vec3>& normals) {
  PaddedPoints points;
  for (const auto& position : positions) points.push_back(padded(position));
  PaddedPoints sums;
  quad_normals(points, quads, sums, normals);
}

void quad_normals(std::span<const Padded> positions,
                  std::span<const Stencils::Quad> quads,
                  PaddedPoints& sums,
                  std::vector<glm::vec3>& normals) {
  add_normals(positions, quads, sums);
  normals.resize(sums.size());
  std::ranges::transform(sums, normals.begin(), unit_vector);
}

}  // namespace bimodal::synth
