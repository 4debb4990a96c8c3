#include "synth/render/cut_faces.hpp"

#include <algorithm>
#include <iterator>

#include <glm/geometric.hpp>
#include <glm/gtc/color_space.hpp>

#include "synth/render/paint.hpp"

namespace bimodal::synth {

namespace {

constexpr float kLineWidth = 0.5F;  // mm
constexpr float kKindLift =
    0.06F;  // mm off the plane from kind to kind: the later hides the former
constexpr float kLineLift = 0.03F;  // mm that a kind's lines are before its face

glm::vec3 linear(const Colour& colour) {
  return glm::convertSRGBToLinear(glm::vec3{colour[0], colour[1], colour[2]} / 255.0F);
}

/// Two triangles along a line in the plane.
void add_stroke(glm::vec3 from,
                glm::vec3 to,
                const glm::vec3& normal,
                std::vector<glm::vec3>& corners) {
  const glm::vec3 along = to - from;
  const float length = glm::length(along);
  if (length == 0.0F) return;
  const glm::vec3 half = 0.5F * kLineWidth / length * along;  // strokes meet without gaps
  const glm::vec3 across = glm::cross(normal, half);
  from -= half;
  to += half;
  corners.insert(
      corners.end(),
      {from - across, to - across, to + across, from - across, to + across, from + across});
}

}  // namespace

CutFaces::CutFaces(std::span<const SurfaceDescription> surfaces,
                   const Plane& plane,
                   const Materials& materials,
                   const PartSet& shown,
                   const glm::mat4& clip_from_world)
    : surfaces_{surfaces},
      normal_{glm::normalize(plane.normal)},
      distance_{static_cast<float>(plane.distance_mm)},
      shown_{shown},
      colours_{linear(materials.cut_skin),
               linear(materials.cut_gums),
               linear(materials.cut_teeth),
               linear(materials.cut_tongue),
               linear(materials.cut_outline)},
      program_{{{"depth.vert"}, {"plain.frag"}}} {
  program_.use();
  program_.set("clip_from_world", clip_from_world);
  glGenVertexArrays(1, &vertex_array_);
  glBindVertexArray(vertex_array_);
  glGenBuffers(1, &buffer_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
}

bool CutFaces::kind_of(const SurfaceDescription& surface, const PartSet& shown, Kind& kind) {
  switch (surface.material) {
    case Material::Skin:
      kind = Kind::Skin;
      return has(shown, HeadPart::Skin);
    case Material::Gum:
      kind = Kind::Gums;
      return has(shown, is_palate(surface) ? HeadPart::Palate : HeadPart::Gum);
    case Material::Tooth:
      kind = Kind::Teeth;
      return has(shown,
                 surface.name == "lower_teeth" ? HeadPart::LowerTooth : HeadPart::UpperTooth);
    case Material::Tongue:
      kind = Kind::Tongue;
      return has(shown, HeadPart::Tongue);
    default:
      return false;
  }
}

void CutFaces::collect(const PosedHead& posed) {
  for (auto& outlines : outlines_) outlines.clear();
  for (auto& polygons : polygons_) polygons.clear();
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    Kind kind{};
    if (!kind_of(surfaces_[s], shown_, kind)) continue;
    const auto found =
        outlines_in(posed.surfaces[s].positions, surfaces_[s].triangles, normal_, distance_);
    auto& outlines = outlines_.at(static_cast<std::size_t>(kind));
    outlines.insert(outlines.end(), found.begin(), found.end());
    if (is_palate(surfaces_[s])) continue;  // a sheet, with air below it: only its line is drawn
    auto& polygons = polygons_.at(static_cast<std::size_t>(kind));
    std::ranges::move(polygons_of(found), std::back_inserter(polygons));
  }
}

void CutFaces::send(std::span<const glm::vec3> corners) const {
  glBindVertexArray(vertex_array_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferData(GL_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(corners.size_bytes()),
               corners.data(),
               GL_STREAM_DRAW);
}

void CutFaces::draw_kind(std::size_t kind) const {
  const glm::vec3 lift = static_cast<float>(kind) * kKindLift * normal_;
  std::vector<glm::vec3> corners;
  for (const auto& polygon : polygons_.at(kind)) {
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
      corners.insert(corners.end(), {polygon[0] + lift, polygon[i] + lift, polygon[i + 1] + lift});
    }
  }
  std::vector<glm::vec3> strokes;
  for (const Outline& outline : outlines_.at(kind)) {
    const auto& points = outline.points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      add_stroke(points[i], points[i + 1], normal_, strokes);
    }
    if (outline.is_closed) add_stroke(points.back(), points.front(), normal_, strokes);
  }
  fill(corners, colours_.at(kind));
  for (glm::vec3& corner : strokes) corner += lift + kLineLift * normal_;
  send(strokes);
  program_.set("plain_colour", colours_.back());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(strokes.size()));
}

void CutFaces::fill(std::span<const glm::vec3> corners, const glm::vec3& colour) const {
  const auto count = static_cast<GLsizei>(corners.size());
  send(corners);
  program_.set("plain_colour", colour);
  glEnable(GL_STENCIL_TEST);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDepthMask(GL_FALSE);
  glDisable(GL_DEPTH_TEST);
  glStencilFunc(GL_ALWAYS, 0, 0xff);
  glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
  glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
  glDrawArrays(GL_TRIANGLES, 0, count);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glStencilFunc(GL_NOTEQUAL, 0, 0xff);
  glStencilOp(GL_ZERO, GL_ZERO, GL_ZERO);
  glDrawArrays(GL_TRIANGLES, 0, count);
  glDisable(GL_STENCIL_TEST);
}

void CutFaces::draw(const PosedHead& posed) {
  collect(posed);
  program_.use();
  glDisable(GL_CULL_FACE);
  for (std::size_t kind = 0; kind < kKinds; ++kind) draw_kind(kind);
  glEnable(GL_CULL_FACE);
}

}  // namespace bimodal::synth
