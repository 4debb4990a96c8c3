#include "synth/render/light_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/gtc/color_space.hpp>

namespace bimodal::synth {

namespace {

struct Spot {
  Material material;
  glm::vec3 place;  // in the rest pose; the subject's left where both sides have one
  bool both_sides;
};

constexpr std::array kSpots{
    Spot{Material::Skin, {0.0F, -68.0F, 104.6F}, false},   // upper lip, midline
    Spot{Material::Skin, {13.0F, -69.0F, 100.0F}, true},   // upper lip, half way
    Spot{Material::Skin, {25.8F, -75.6F, 85.4F}, true},    // mouth corner
    Spot{Material::Skin, {13.0F, -84.0F, 97.0F}, true},    // lower lip, half way
    Spot{Material::Skin, {0.0F, -86.0F, 101.1F}, false},   // lower lip, midline
    Spot{Material::Tooth, {4.3F, -75.0F, 93.0F}, true},    // upper incisor
    Spot{Material::Tooth, {2.7F, -79.0F, 90.0F}, true},    // lower incisor
    Spot{Material::Tongue, {0.0F, -80.5F, 86.0F}, false},  // tip
    Spot{Material::Tongue, {6.0F, -76.0F, 74.0F}, true},   // blade
    Spot{Material::Skin, {0.0F, -107.0F, 103.0F}, false},  // chin
    Spot{Material::Skin, {22.0F, -103.0F, 92.0F}, true},   // beside the chin
    Spot{Material::Skin, {48.0F, -85.0F, 60.0F}, true},    // jaw
    Spot{Material::Skin, {40.0F, -58.0F, 76.0F}, true},    // cheek
    Spot{Material::Skin, {40.0F, -30.0F, 84.0F}, true},    // cheek bone
    Spot{Material::Skin, {0.0F, -45.0F, 118.0F}, false},   // tip of the nose
    Spot{Material::Skin, {20.0F, 20.0F, 98.0F}, true},     // brow
};

constexpr float kSpotDiameter = 3.2F;    // mm
constexpr float kVertexDiameter = 0.6F;  // mm
constexpr float kLift = 1.5F;            // mm towards the camera, out of the surface
constexpr float kLipSpacing = 3.5F;      // mm between lip points

SurfaceVertex nearest(std::span<const SurfaceDescription> surfaces,
                      Material material,
                      const glm::vec3& place) {
  SurfaceVertex found;
  float least = std::numeric_limits<float>::max();
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (surfaces[s].material != material) continue;
    for (std::size_t v = 0; v < surfaces[s].rest_positions.size(); ++v) {
      const float distance = glm::distance(surfaces[s].rest_positions[v], place);
      if (distance >= least) continue;
      least = distance;
      found = {s, v};
    }
  }
  return found;
}

std::vector<SurfaceVertex> sparse(std::span<const SurfaceDescription> surfaces) {
  std::vector<SurfaceVertex> vertices;
  for (const Spot& spot : kSpots) {
    vertices.push_back(nearest(surfaces, spot.material, spot.place));
    if (!spot.both_sides) continue;
    const glm::vec3 right{-spot.place.x, spot.place.y, spot.place.z};
    vertices.push_back(nearest(surfaces, spot.material, right));
  }
  return vertices;
}

bool is_on_vermilion(const SurfaceDescription& surface, std::size_t vertex) {
  constexpr float kBorder = 0.45F;
  constexpr float kInside = 1.7F;
  return surface.material == Material::Skin && surface.lip[vertex] > kBorder &&
         surface.lip[vertex] < kInside;
}

std::vector<SurfaceVertex> on_lips(std::span<const SurfaceDescription> surfaces) {
  std::vector<SurfaceVertex> vertices;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const auto& places = surfaces[s].rest_positions;
    for (std::size_t v = 0; v < places.size(); ++v) {
      const bool is_free = std::ranges::none_of(vertices, [&](const SurfaceVertex& other) {
        return glm::distance(surfaces[other.surface].rest_positions[other.vertex], places[v]) <
               kLipSpacing;
      });
      if (is_on_vermilion(surfaces[s], v) && is_free) vertices.push_back({s, v});
    }
  }
  return vertices;
}

std::vector<SurfaceVertex> every(std::span<const SurfaceDescription> surfaces) {
  std::vector<SurfaceVertex> vertices;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    for (std::size_t v = 0; v < surfaces[s].rest_positions.size(); ++v) vertices.push_back({s, v});
  }
  return vertices;
}

}  // namespace

std::vector<SurfaceVertex> shining_vertices(std::span<const SurfaceDescription> surfaces,
                                            Points points) {
  switch (points) {
    case Points::Sparse:
      return sparse(surfaces);
    case Points::Lips:
      return on_lips(surfaces);
    case Points::All:
      return every(surfaces);
    case Points::None:
      break;
  }
  return {};
}

LightPoints::LightPoints(std::span<const SurfaceDescription> surfaces,
                         const Appearance& appearance,
                         const View& view,
                         const Camera& camera)
    : vertices_{shining_vertices(surfaces, appearance.points)},
      camera_{camera.position},
      program_{{{"point.vert"}, {"point.frag"}}} {
  const float diameter = appearance.points == Points::All ? kVertexDiameter : kSpotDiameter;
  const auto pixels_per_mm = static_cast<float>(static_cast<double>(view.height) / view.field_mm);
  const Colour& colour = appearance.materials.points;
  program_.use();
  program_.set("clip_from_world", camera.clip_from_world);
  program_.set("diameter", std::max(1.0F, diameter * pixels_per_mm));
  program_.set("plain_colour",
               glm::convertSRGBToLinear(glm::vec3{colour[0], colour[1], colour[2]} / 255.0F));
  glGenVertexArrays(1, &vertex_array_);
  glBindVertexArray(vertex_array_);
  glGenBuffers(1, &buffer_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
}

void LightPoints::draw(const PosedHead& posed) {
  positions_.clear();
  for (const auto& [surface, vertex] : vertices_) {
    const glm::vec3& at = posed.surfaces[surface].positions[vertex];
    positions_.push_back(at + kLift * glm::normalize(camera_ - at));
  }
  glBindVertexArray(vertex_array_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  const std::span<const glm::vec3> sent{positions_};
  glBufferData(
      GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(sent.size_bytes()), sent.data(), GL_STREAM_DRAW);
  program_.use();
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(positions_.size()));
  glDisable(GL_PROGRAM_POINT_SIZE);
}

}  // namespace bimodal::synth
