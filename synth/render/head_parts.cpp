#include "synth/render/head_parts.hpp"

namespace bimodal::synth {

namespace {

using enum HeadPart;

constexpr std::array<PartLook, kHeadPartCount> kLooks{{
    // part, shader, definition, sky floor, shadow floor, softness, exponents and grain
    {Skin, "skin.frag", "", 0.0F, 0.0F, 1.0F, {}},
    {Lips, "skin.frag", "LIPS", 0.03F, 0.0F, 1.0F, {}},
    {Brow, "skin.frag", "BROW", 0.0F, 0.0F, 1.0F, {}},
    {Hair, "skin.frag", "HAIR", 0.0F, 0.0F, 0.6F, {}},
    {Eye, "eye.frag", "", 0.0F, 0.0F, 0.25F, {}},
    {Tooth, "mouth.frag", "", 0.30F, 0.35F, 0.35F, {45.0F, 157.0F, 0.0F}},
    {Gum, "mouth.frag", "", 0.18F, 0.0F, 1.0F, {25.0F, 87.0F, 0.0F}},
    {Tongue, "mouth.frag", "", 0.30F, 0.34F, 1.0F, {22.0F, 77.0F, 0.25F}},
    {Lash, "lash.frag", "", 0.0F, 0.0F, 0.0F, {}},
    {Cornea, "cornea.frag", "", 0.0F, 0.0F, 0.0F, {}},
}};

constexpr bool in_order_of_the_enumeration() {
  for (std::size_t i = 0; i < kHeadPartCount; ++i) {
    if (static_cast<std::size_t>(kLooks.at(i).part) != i) return false;
  }
  return true;
}

static_assert(in_order_of_the_enumeration());

HeadPart skin_part(SkinDetail detail) {
  switch (detail) {
    case SkinDetail::Lips: return Lips;
    case SkinDetail::Brow: return Brow;
    case SkinDetail::Hair: return Hair;
    case SkinDetail::None: break;
  }
  return Skin;
}

HeadPart part_of(const SurfaceDescription& surface,
                 const std::vector<VertexPaint>& paint,
                 const std::uint32_t* triangle) {
  switch (surface.material) {
    case Material::Tooth: return Tooth;
    case Material::Gum: return Gum;
    case Material::Tongue: return Tongue;
    case Material::Eye: return Eye;
    case Material::Cornea: return Cornea;
    case Material::Lash: return Lash;
    case Material::Skin: break;
  }
  return skin_part(skin_detail(surface, paint, triangle));
}

}  // namespace

std::span<const PartLook, kHeadPartCount> part_looks() {
  return kLooks;
}

SortedTriangles sort_by_part(std::span<const SurfaceDescription> surfaces,
                             std::span<const std::vector<VertexPaint>> paints) {
  SortedTriangles sorted;
  std::uint32_t first_vertex = 0;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const SurfaceDescription& surface = surfaces[s];
    for (std::size_t i = 0; i + 2 < surface.triangles.size(); i += 3) {
      const std::uint32_t* triangle = &surface.triangles[i];
      const HeadPart part = part_of(surface, paints[s], triangle);
      auto& indices = sorted.indices.at(static_cast<std::size_t>(part));
      for (std::size_t corner = 0; corner < 3; ++corner) {
        indices.push_back(first_vertex + triangle[corner]);
      }
    }
    first_vertex += static_cast<std::uint32_t>(surface.rest_positions.size());
  }
  return sorted;
}

}  // namespace bimodal::synth
