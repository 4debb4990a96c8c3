#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "synth/face/surface.hpp"
#include "synth/render/head_part.hpp"
#include "synth/render/paint.hpp"
#include "synth/render/quality.hpp"

namespace bimodal::synth {

/// How a part takes light.
struct PartLook {
  HeadPart part;
  std::string_view shader;      ///< the fragment shader's own file
  std::string_view definition;  ///< what is #defined in it
  float sky_floor;     ///< 0..1: light from around that reaches it in spite of what covers it
  float shadow_floor;  ///< 0..1: key light that reaches it in spite of what covers it
  float softness;      ///< 1 like skin, 0 like wood: how far light creeps round the form
  float exponent;      ///< of the broad highlight
  float grain;         ///< mouth parts: roughness of colour
};

/// One row per part, in the order of the enumeration.
[[nodiscard]] std::span<const PartLook, kHeadPartCount> part_looks();

/// The triangles worth drawing of one part; vertices are numbered through all surfaces.
struct PartTriangles {
  std::vector<std::uint32_t> near;  ///< those that the camera may see while the head looks ahead
  std::vector<std::uint32_t> far;   ///< those that it can see only when the head turns
};

/// One per part. `paints`: one per surface; `towards_camera`: unit vector.
[[nodiscard]] std::array<PartTriangles, kHeadPartCount> sort_by_part(
    std::span<const SurfaceDescription> surfaces,
    std::span<const std::vector<VertexPaint>> paints,
    const PosedHead& resting,
    const glm::vec3& towards_camera,
    Quality quality);

}  // namespace bimodal::synth
