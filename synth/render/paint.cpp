#include "synth/render/paint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/color_space.hpp>

#include "synth/render/solid_noise.hpp"

namespace bimodal::synth {

namespace {

using glm::mix;
using glm::vec2;
using glm::vec3;

vec3 linear(const Colour& colour) {
  return glm::convertSRGBToLinear(vec3{colour[0], colour[1], colour[2]} / 255.0F);
}

float bell(float distance, float width) {
  return std::exp(-distance * distance / (2.0F * width * width));
}

float clamp01(float x) {
  return std::clamp(x, 0.0F, 1.0F);
}

// The middle line of the subject's left brow in the rest pose, from the nose outward: y and half
// width, mm.

constexpr float kBrowStart = 11.0F;  // mm from the midline; points stand 4 mm apart in x
constexpr float kBrowStep = 4.0F;
constexpr std::array<vec2, 12> kBrowHeightAndHalfWidth{{{17.0F, 3.2F},
                                                        {18.6F, 4.0F},
                                                        {20.0F, 4.3F},
                                                        {21.3F, 4.2F},
                                                        {22.4F, 4.0F},
                                                        {23.3F, 3.7F},
                                                        {24.0F, 3.3F},
                                                        {24.3F, 2.9F},
                                                        {24.0F, 2.4F},
                                                        {22.9F, 1.9F},
                                                        {21.0F, 1.4F},
                                                        {18.6F, 0.8F}}};
constexpr float kBrowFront = 30.0F;  // mm; what lies farther back in z is no forehead
constexpr float kBrowReach = 9.0F;   // mm from the middle line at which no hair can stand

/// Coordinates along and across the brow of the nearest point on its middle line.
vec3 brow_coordinates(vec3 rest) {
  const vec2 point{std::abs(rest.x), rest.y};
  float nearest = std::numeric_limits<float>::max();
  vec3 coordinates{};
  constexpr std::size_t kSegments = kBrowHeightAndHalfWidth.size() - 1;
  for (std::size_t i = 0; i < kSegments; ++i) {
    const float x = kBrowStart + kBrowStep * static_cast<float>(i);
    const vec2 from{x, kBrowHeightAndHalfWidth.at(i).x};
    const vec2 along = vec2{x + kBrowStep, kBrowHeightAndHalfWidth.at(i + 1).x} - from;
    const float exact = glm::dot(point - from, along) / glm::dot(along, along);
    const float t = clamp01(exact);
    const float distance = glm::length(point - from - t * along);
    if (distance >= nearest) continue;
    nearest = distance;
    // Beyond both ends the line goes on, so that what is between two vertices stays smooth.
    const bool beyond = (i == 0 && exact < 0.0F) || (i == kSegments - 1 && exact > 1.0F);
    const vec2 left = vec2{-along.y, along.x} / glm::length(along);
    coordinates = {(static_cast<float>(i) + (beyond ? exact : t)) / static_cast<float>(kSegments),
                   beyond ? glm::dot(point - from, left)
                          : std::copysign(distance, glm::dot(point - from, left)),
                   mix(kBrowHeightAndHalfWidth.at(i).y, kBrowHeightAndHalfWidth.at(i + 1).y, t)};
  }
  return coordinates;
}

/// Redness of cheeks, nose, chin and philtrum.
float blush(vec3 rest) {
  const float side = std::abs(rest.x);
  const float cheeks = bell(std::hypot((side - 40.0F) * 0.9F, rest.y + 30.0F), 15.0F);
  const float nose = bell(std::hypot(rest.x, (rest.y + 43.0F) * 0.9F), 10.0F);
  const float chin = bell(std::hypot(rest.x, rest.y + 104.0F), 13.0F);
  const float philtrum = bell(rest.y + 62.0F, 6.0F) * bell(rest.x, 16.0F);
  return 0.75F * cheeks * (rest.z > 20.0F ? 1.0F : 0.0F) + 0.55F * nose + 0.35F * chin +
         0.25F * philtrum * (rest.z > 60.0F ? 1.0F : 0.0F);
}

VertexPaint paint_skin(vec3 rest, float darkness, const Materials& materials) {
  constexpr float kMeanOfNoise = 0.44F;
  const float patches = materials.texture * (cloudy_noise(rest * 0.035F) - kMeanOfNoise);
  const float pores = materials.texture * (cloudy_noise(rest * 0.25F) - kMeanOfNoise);
  vec3 albedo = linear(materials.skin) * (1.0F + 0.10F * patches + 0.10F * pores);
  albedo = mix(albedo, linear(materials.blush), 0.34F * clamp01(blush(rest) + 0.35F * patches));
  const float socket = bell((std::abs(rest.x) - 31.0F) * 0.75F, 13.0F) *
                       bell(rest.y + 5.0F, 10.0F) * (rest.z > 50.0F ? 1.0F : 0.0F);
  albedo = mix(albedo, linear(materials.sockets), 0.35F * socket);

  const float dark = clamp01(darkness);
  albedo = mix(albedo, linear(materials.nostrils), dark);
  const float oily_nose = 0.05F * bell(rest.x, 10.0F) * (rest.z > 60.0F ? 1.0F : 0.0F);
  return {albedo,
          vec2{0.045F + oily_nose, 0.03F} * (1.0F - dark),
          rest.z > kBrowFront ? brow_coordinates(rest) : vec3{0.0F, kBrowReach, 1.0F}};
}

VertexPaint paint_tooth(vec3 rest, float towards_gum, const Materials& materials) {
  const vec3 enamel =
      linear(materials.enamel) * (1.0F - materials.texture * 0.12F * solid_noise(rest * 0.6F));
  const float neck = glm::smoothstep(0.55F, 1.0F, towards_gum);
  return {mix(enamel, linear(materials.teeth_necks), 0.6F * neck), {0.12F, 0.22F}, {}};
}

VertexPaint paint_gum(vec3 rest, const Colour& colour, float texture) {
  const float mottling = 1.0F + texture * 0.2F * (solid_noise(rest * 0.5F) - 0.5F);
  return {linear(colour) * mottling, {0.06F, 0.12F}, {}};
}

VertexPaint paint_tongue(vec3 rest, const Materials& materials) {
  const float mottling = 1.0F + materials.texture * 0.2F * (cloudy_noise(rest * 0.35F) - 0.44F);
  return {linear(materials.tongue) * mottling, {0.05F, 0.10F}, {}};
}

VertexPaint paint_vertex(const SurfaceDescription& surface,
                         const Materials& materials,
                         std::size_t vertex) {
  const vec3 rest = surface.rest_positions[vertex];
  const float special = surface.special.empty() ? 0.0F : surface.special[vertex];
  switch (surface.material) {
    case Material::Skin:
      return paint_skin(rest, special, materials);
    case Material::Tooth:
      return paint_tooth(rest, special, materials);
    case Material::Gum:
      return paint_gum(
          rest, is_palate(surface) ? materials.palate : materials.gums, materials.texture);
    case Material::Tongue:
      return paint_tongue(rest, materials);
    case Material::Lash:
      return {linear(materials.lashes), {0.02F, 0.0F}, {}};
    case Material::Eye:
    case Material::Cornea:
      break;  // painted per pixel
  }
  return {};
}

}  // namespace

bool on_brow(glm::vec3 brow) {
  constexpr float kBeyond = 0.2F;  // part of the brow's length, past its ends
  constexpr float kHairs = 7.0F;   // mm from the middle line
  return std::abs(brow.y) < kHairs && brow.x > -kBeyond && brow.x < 1.0F + kBeyond;
}

bool is_palate(const SurfaceDescription& surface) {
  return surface.name.find("palate") != std::string::npos;
}

bool is_ear(const SurfaceDescription& surface) {
  return surface.name.ends_with("ear");
}

std::vector<VertexPaint> paint(const SurfaceDescription& surface, const Materials& materials) {
  std::vector<VertexPaint> painted;
  painted.reserve(surface.rest_positions.size());
  for (std::size_t i = 0; i < surface.rest_positions.size(); ++i) {
    painted.push_back(paint_vertex(surface, materials, i));
  }
  return painted;
}

SkinDetail skin_detail(const SurfaceDescription& surface,
                       const std::vector<VertexPaint>& paint,
                       std::span<const std::uint32_t, 3> triangle) {
  constexpr float kFaintestLip = 0.2F;  // skin.frag's border begins at 0.33 -/+ noise
  constexpr float kMouthWall = 2.95F;   // farther in than where the lips touch
  constexpr float kFaintestHair = 0.02F;
  const auto any = [triangle](auto&& has) { return std::ranges::any_of(triangle, has); };
  const bool is_wall =
      std::ranges::all_of(triangle, [&](std::uint32_t v) { return surface.lip[v] > kMouthWall; });
  if (is_wall) return SkinDetail::MouthWall;
  if (any([&](std::uint32_t v) { return surface.lip[v] > kFaintestLip; })) return SkinDetail::Lips;
  if (any([&](std::uint32_t v) { return surface.scalp[v] > kFaintestHair; })) {
    return SkinDetail::Hair;
  }
  if (any([&](std::uint32_t v) { return on_brow(paint[v].brow); })) {
    return SkinDetail::Brow;
  }
  return SkinDetail::None;
}

}  // namespace bimodal::synth
