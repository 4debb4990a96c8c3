#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "synth/face/surface.hpp"
#include "synth/render/paint.hpp"

namespace bimodal::synth {

/// The triangles that are worth drawing. Small triangles are what drawing in software costs most
/// (half of a 1 mm triangle's pixels are worked out for nothing), and most of the head is so flat
/// that a mesh of half the resolution looks the same.
///
/// A patch is eight triangles of `surface.triangles` in a row round one common vertex, as a step of
/// subdivision leaves them. Where its normals differ by no more than an angle that depends on the
/// material, and it has no detail that needs all its vertices, it becomes two triangles, or a fan
/// where it meets a patch that stays fine: never a gap. What is not in such patches stays as it is.
/// `normals`: at rest, one per vertex.
[[nodiscard]] std::vector<std::uint32_t> triangles_worth_drawing(
    const SurfaceDescription& surface,
    const std::vector<VertexPaint>& paint,
    std::span<const glm::vec3> normals);

}  // namespace bimodal::synth
