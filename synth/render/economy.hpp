#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "synth/face/surface.hpp"
#include "synth/render/paint.hpp"
#include "synth/render/quality.hpp"

namespace bimodal::synth {

/// The triangles that are worth drawing. Small triangles are what drawing in software costs most
/// (three quarters of the pixels that are worked out for 1 mm triangles are worked out for
/// nothing), and most of the head is so flat that a coarser mesh looks the same.
///
/// A patch is eight triangles of `surface.triangles` in a row round one common vertex, as a step of
/// subdivision leaves them; a block is four patches in a row round one vertex, as the step before
/// leaves them. Where the normals of a patch differ by no more than an angle that depends on the
/// material, and it has no detail that needs all its vertices, it becomes two triangles, or a fan
/// where it meets what stays finer: never a gap. So does a block, where it faces the camera as
/// well: only on the outline would its edges be seen. What is not in such patches stays as it is.
/// Full quality halves the angles and makes no blocks.
/// `normals`: at rest, one per vertex; `towards_camera`: unit vector.
[[nodiscard]] std::vector<std::uint32_t> triangles_worth_drawing(
    const SurfaceDescription& surface,
    const std::vector<VertexPaint>& paint,
    std::span<const glm::vec3> normals,
    const glm::vec3& towards_camera,
    Quality quality);

}  // namespace bimodal::synth
