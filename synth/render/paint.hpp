#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "synth/face/surface.hpp"
#include "synth/render/materials.hpp"

namespace bimodal::synth {

/// How a point of the head is coloured, as far as a resolution of 1-2 mm is enough: worked out once
/// per vertex. Lips, brows and hair are added per pixel by skin.frag.
struct VertexPaint {
  glm::vec3 albedo{};  ///< linear red, green, blue, 0..1
  glm::vec2 gloss{};   ///< strength of the broad and of the sharp highlight
  glm::vec3 brow{};    ///< along the brow 0..1 from the nose, mm above its middle, half width in mm
};

/// One for each vertex of `surface`. Colours are fixed functions of the rest position.
[[nodiscard]] std::vector<VertexPaint> paint(const SurfaceDescription& surface,
                                             const Materials& materials);

/// Whether a surface of gum is the roof of the mouth.
[[nodiscard]] bool is_palate(const SurfaceDescription& surface);

[[nodiscard]] bool is_ear(const SurfaceDescription& surface);

/// Whether hair of the brow can stand at VertexPaint::brow.
[[nodiscard]] bool on_brow(glm::vec3 brow);

/// Which of skin.frag's details a skin triangle needs; most need none.
enum class SkinDetail : std::uint8_t { None, Lips, MouthWall, Brow, Hair };

/// For the triangle of these three vertices.
[[nodiscard]] SkinDetail skin_detail(const SurfaceDescription& surface,
                                     const std::vector<VertexPaint>& paint,
                                     std::span<const std::uint32_t, 3> triangle);

}  // namespace bimodal::synth
