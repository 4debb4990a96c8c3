#include "synth/face/eyes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "synth/face/eyeball.hpp"
#include "synth/face/quad_normals.hpp"
#include "synth/face/stencils.hpp"

namespace bimodal::synth {

namespace {

using Carrier = RigidPart::Carrier;

glm::dvec3 centre(bool left) {
  return {left ? kLeftEyeCentre.x : -kLeftEyeCentre.x, kLeftEyeCentre.y, kLeftEyeCentre.z};
}

/// The cage as a unit sphere, subdivided.
struct Sphere {
  std::vector<glm::vec3> points;
  std::vector<Stencils::Quad> quads;
  std::vector<std::uint32_t> triangles;
};

Sphere sphere(const Cage& cage, bool left, int levels) {
  std::vector<glm::dvec3> unit;
  for (const auto& vertex : cage.vertices) unit.push_back((vertex - centre(left)) / kEyeRadius);
  const Stencils stencils{cage.vertices.size(), cage.faces, levels};
  Sphere result{.points = {},
                .quads = {stencils.quads().begin(), stencils.quads().end()},
                .triangles = stencils.triangles()};
  stencils.apply(unit, result.points);
  return result;
}

float degrees_from_gaze(const glm::vec3& unit) {
  return glm::degrees(std::acos(std::clamp(unit.z, -1.0F, 1.0F)));
}

RigidPart ball(const Sphere& unit, bool left) {
  RigidPart part{.carrier = left ? Carrier::LeftEye : Carrier::RightEye,
                 .description = unmasked(Material::Eye, unit.triangles, unit.points),
                 .at_rest = {.positions = {}, .normals = unit.points}};
  for (const auto& point : unit.points) {
    part.at_rest.positions.emplace_back(glm::dvec3{point} * kEyeRadius + centre(left));
  }
  return part;
}

/// A shell 0.12 mm before the ball, 0.95 mm more at the pole, over the front 75 degrees.
RigidPart cornea(const Sphere& unit, bool left) {
  RigidPart part{.carrier = left ? Carrier::LeftEye : Carrier::RightEye,
                 .description = unmasked(Material::Cornea, {}, unit.points),
                 .at_rest = {}};
  for (const auto& point : unit.points) {
    const float angle = degrees_from_gaze(point) / 33.0F;
    const float bulge = 0.95F * std::max(0.0F, 1.0F - angle * angle);
    part.at_rest.positions.push_back(point * (static_cast<float>(kEyeRadius) + 0.12F + bulge) +
                                     glm::vec3{centre(left)});
  }
  quad_normals(part.at_rest.positions, unit.quads, part.at_rest.normals);
  for (const auto& quad : unit.quads) {
    const bool in_front = std::ranges::all_of(
        quad, [&](auto vertex) { return degrees_from_gaze(unit.points[vertex]) < 75.0F; });
    if (!in_front) continue;
    const auto [a, b, c, d] = quad;
    part.description.triangles.insert(part.description.triangles.end(), {a, b, c, a, c, d});
  }
  return part;
}

/// An ellipsoid with the sphere's topology.
RigidPart ellipsoid(const Sphere& unit,
                    const glm::vec3& half_axes,
                    const glm::vec3& middle,
                    std::vector<glm::vec3> rest_positions) {
  RigidPart part{.carrier = Carrier::Head,
                 .description = unmasked(Material::Eye, unit.triangles, std::move(rest_positions)),
                 .at_rest = {}};
  for (const auto& point : unit.points) {
    part.at_rest.positions.push_back(point * half_axes + middle);
    part.at_rest.normals.push_back(glm::normalize(point / half_axes));
  }
  return part;
}

}  // namespace

std::vector<RigidPart> eye_parts(const Cage& cage, bool left) {
  const float side = left ? 1.0F : -1.0F;
  auto fine = sphere(cage, left, 2);
  for (auto& point : fine.points) point = glm::normalize(point);
  const auto coarse = sphere(cage, left, 1);

  std::vector<glm::vec3> on_white;
  std::vector<glm::vec3> on_caruncle;
  for (const auto& point : coarse.points) {
    on_white.emplace_back(side * point.x, point.y, -9.0F);
    on_caruncle.push_back(0.2F * point - glm::vec3{0.0F, 0.0F, 1.0F});
  }
  std::vector<RigidPart> parts;
  parts.push_back(ball(fine, left));
  parts.push_back(
      ellipsoid(coarse, {15.4F, 9.0F, 10.3F}, glm::vec3{centre(left)}, std::move(on_white)));
  parts.push_back(
      ellipsoid(coarse, {2.3F, 1.9F, 2.0F}, {18.3F * side, -1.5F, 75.0F}, std::move(on_caruncle)));
  parts.push_back(cornea(fine, left));
  for (auto& part : parts) part.description.name = cage.name;
  return parts;
}

RigidMotion gaze(bool left, double x_deg, double y_deg) {
  return rotation_about(centre(left), rotation_about_y(x_deg) * rotation_about_x(y_deg));
}

}  // namespace bimodal::synth
