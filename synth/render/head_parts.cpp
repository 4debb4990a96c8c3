#include "synth/render/head_parts.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "synth/render/economy.hpp"

namespace bimodal::synth {

namespace {

using enum HeadPart;

constexpr std::array<PartLook, kHeadPartCount> kLooks{{
    // part, shader, definition, sky floor, shadow floor, softness, exponent, grain
    {Skin, "skin.frag", "", 0.0F, 0.0F, 1.0F, 16.0F, 0.0F},
    {Ear, "skin.frag", "", 0.0F, 0.0F, 1.0F, 16.0F, 0.0F},
    {Lips, "skin.frag", "LIPS", 0.03F, 0.0F, 1.0F, 26.0F, 0.0F},
    {Brow, "skin.frag", "BROW", 0.0F, 0.0F, 1.0F, 16.0F, 0.0F},
    {Hair, "skin.frag", "HAIR", 0.0F, 0.0F, 0.6F, 16.0F, 0.0F},
    {Eye, "eye.frag", "", 0.0F, 0.0F, 0.25F, 16.0F, 0.0F},
    {MouthWall, "skin.frag", "LIPS", 0.14F, 0.12F, 1.0F, 26.0F, 0.0F},
    {UpperTooth, "mouth.frag", "", 0.30F, 0.35F, 0.35F, 45.0F, 0.0F},
    {LowerTooth, "mouth.frag", "", 0.30F, 0.35F, 0.35F, 45.0F, 0.0F},
    {Gum, "mouth.frag", "", 0.18F, 0.0F, 1.0F, 25.0F, 0.0F},
    {Palate, "mouth.frag", "", 0.18F, 0.0F, 1.0F, 25.0F, 0.0F},
    {Tongue, "mouth.frag", "TONGUE", 0.30F, 0.34F, 1.0F, 22.0F, 0.25F},
    {Lash, "lash.frag", "", 0.0F, 0.0F, 0.0F, 16.0F, 0.0F},
    {Cornea, "cornea.frag", "", 0.0F, 0.0F, 0.0F, 16.0F, 0.0F},
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
    case SkinDetail::Lips:
      return Lips;
    case SkinDetail::MouthWall:
      return MouthWall;
    case SkinDetail::Brow:
      return Brow;
    case SkinDetail::Hair:
      return Hair;
    case SkinDetail::None:
      break;
  }
  return Skin;
}

HeadPart part_of(const SurfaceDescription& surface,
                 const std::vector<VertexPaint>& paint,
                 std::span<const std::uint32_t, 3> triangle) {
  switch (surface.material) {
    case Material::Tooth:
      return surface.name == "lower_teeth" ? LowerTooth : UpperTooth;
    case Material::Gum:
      return is_palate(surface) ? Palate : Gum;
    case Material::Tongue:
      return Tongue;
    case Material::Eye:
      return Eye;
    case Material::Cornea:
      return Cornea;
    case Material::Lash:
      return Lash;
    case Material::Skin:
      break;
  }
  const HeadPart part = skin_part(skin_detail(surface, paint, triangle));
  return part == Skin && is_ear(surface) ? Ear : part;
}

/// Whether speech turns the part's surface by no more than the 20 degrees allowed for below.
bool stays_firm(HeadPart part) {
  return part != Lips && part != MouthWall && part != Tongue && part != Lash && part != Cornea;
}

/// By 30 degrees beyond the horizon: 8 for perspective, the rest for movement.
bool faces_away(std::span<const std::uint32_t, 3> triangle,
                const std::vector<glm::vec3>& normals,
                const glm::vec3& towards_camera) {
  constexpr float kBeyondHorizon = -0.5F;
  return std::ranges::all_of(triangle, [&](std::uint32_t vertex) {
    return glm::dot(normals[vertex], towards_camera) < kBeyondHorizon;
  });
}

}  // namespace

std::span<const PartLook, kHeadPartCount> part_looks() {
  return kLooks;
}

std::array<PartTriangles, kHeadPartCount> sort_by_part(
    std::span<const SurfaceDescription> surfaces,
    std::span<const std::vector<VertexPaint>> paints,
    const PosedHead& resting,
    const glm::vec3& towards_camera,
    Quality quality) {
  std::array<PartTriangles, kHeadPartCount> sorted;
  std::uint32_t first_vertex = 0;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const SurfaceDescription& surface = surfaces[s];
    const std::vector<glm::vec3>& normals = resting.surfaces[s].normals;
    const std::vector<std::uint32_t> triangles =
        triangles_worth_drawing(surface, paints[s], normals, towards_camera, quality);
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
      const std::span<const std::uint32_t, 3> triangle{&triangles[i], 3};
      const HeadPart part = part_of(surface, paints[s], triangle);
      PartTriangles& own = sorted.at(static_cast<std::size_t>(part));
      const bool is_far = stays_firm(part) && faces_away(triangle, normals, towards_camera);
      auto& indices = is_far ? own.far : own.near;
      for (const std::uint32_t vertex : triangle) indices.push_back(first_vertex + vertex);
    }
    first_vertex += static_cast<std::uint32_t>(surface.rest_positions.size());
  }
  return sorted;
}

}  // namespace bimodal::synth
