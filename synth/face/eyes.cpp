#include "synth/face/eyes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
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
};

Sphere sphere(const Cage& cage, bool left, int levels) {
  std::vector<glm::dvec3> unit;
  for (const auto& vertex : cage.vertices) unit.push_back((vertex - centre(left)) / kEyeRadius);
  const Stencils stencils{cage.vertices.size(), cage.faces, levels};
  Sphere result{.points = {}, .quads = {stencils.quads().begin(), stencils.quads().end()}};
  stencils.apply(unit, result.points);
  return result;
}

float degrees_from_gaze(const glm::vec3& unit) {
  return glm::degrees(std::acos(std::clamp(unit.z, -1.0F, 1.0F)));
}

constexpr float kFrontDeg = 75.0F;  ///< from the gaze: what of ball and cornea is ever seen

std::vector<std::uint32_t> front_triangles(const Sphere& unit) {
  std::vector<std::uint32_t> triangles;
  for (const auto& quad : unit.quads) {
    const bool in_front = std::ranges::all_of(
        quad, [&](auto vertex) { return degrees_from_gaze(unit.points[vertex]) < kFrontDeg; });
    if (!in_front) continue;
    const auto [a, b, c, d] = quad;
    triangles.insert(triangles.end(), {a, b, c, a, c, d});
  }
  return triangles;
}

/// Radius of the ball at an angle from the gaze. The iris stands before the white, wherever it
/// looks; what lies round it dives beneath the white, whose normals and colour are alike there.
float ball_radius(float angle_deg) {
  constexpr float kIrisBefore = 0.2F;
  constexpr float kRestBehind = 1.0F;
  const float dived = std::clamp((angle_deg - 29.0F) / 10.0F, 0.0F, 1.0F);
  return static_cast<float>(kEyeRadius) + std::lerp(kIrisBefore, -kRestBehind, dived);
}

RigidPart ball(const Sphere& unit, bool left) {
  RigidPart part{.carrier = left ? Carrier::LeftEye : Carrier::RightEye,
                 .description = unmasked(Material::Eye, front_triangles(unit), unit.points),
                 .at_rest = {.positions = {}, .normals = unit.points}};
  for (const auto& point : unit.points) {
    part.at_rest.positions.push_back(point * ball_radius(degrees_from_gaze(point)) +
                                     glm::vec3{centre(left)});
  }
  return part;
}

/// A shell 0.32 mm before the white, 0.75 mm more at the pole.
RigidPart cornea(const Sphere& unit, bool left) {
  RigidPart part{.carrier = left ? Carrier::LeftEye : Carrier::RightEye,
                 .description = unmasked(Material::Cornea, front_triangles(unit), unit.points),
                 .at_rest = {}};
  for (const auto& point : unit.points) {
    const float angle = degrees_from_gaze(point) / 33.0F;
    const float bulge = 0.75F * std::max(0.0F, 1.0F - angle * angle);
    part.at_rest.positions.push_back(point * (static_cast<float>(kEyeRadius) + 0.32F + bulge) +
                                     glm::vec3{centre(left)});
  }
  quad_normals(part.at_rest.positions, unit.quads, part.at_rest.normals);
  return part;
}

/// What of the eye does not turn and is seen between the lids: a field of heights over an almond a
/// little larger than their opening. Millimetres from the centre; x from nose to temple.
namespace white {

constexpr int kColumns = 26;  // even, as are the rows
constexpr int kRows = 10;
constexpr double kInner = -16.6;
constexpr double kOuter = 15.0;

double bell(double distance) {
  return std::exp(-0.5 * distance * distance);
}

/// The caruncle, and beside it the fold where the white of the eyeball ends.
double flesh(double x, double y) {
  const double caruncle = 2.6 * bell(std::hypot((x + 14.1) / 1.4, (y + 1.35) / 1.0));
  const double fold = 0.4 * bell(std::hypot((x + 10.9) / 0.6, (y + 0.9) / 2.2));
  return caruncle + fold;
}

double height(double x, double y) {
  return height_round_eye(std::hypot(x, y), kEyeRadius) + flesh(x, y);
}

glm::vec3 normal(double x, double y) {
  constexpr double kStep = 0.01;
  return glm::normalize(glm::dvec3{height(x - kStep, y) - height(x + kStep, y),
                                   height(x, y - kStep) - height(x, y + kStep),
                                   2.0 * kStep});
}

/// `share` of the columns from the inner end, where they stand closer; `across` -1 below to 1
/// above.
glm::dvec3 point(double share, double across) {
  const double along = std::pow(share, 1.3);
  const double x = std::lerp(kInner, kOuter, along);
  const double middle = std::lerp(-1.8, 1.1, along);
  const double half = 2.2 + 4.9 * std::pow(std::sin(glm::pi<double>() * along), 0.8);
  const double y = middle + half * across;
  return {x, y, height(x, y)};
}

}  // namespace white

/// Two by two fields at a time round their common corner, as subdivision leaves them, so that they
/// may be drawn coarse.
std::vector<std::uint32_t> white_triangles(bool left) {
  constexpr std::array<std::array<int, 2>, 8> kOutline{
      {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};
  std::vector<std::uint32_t> triangles;
  for (int column = 0; column < white::kColumns; column += 2) {
    for (int row = 0; row < white::kRows; row += 2) {
      const auto vertex = [&](int right, int up) {
        return static_cast<std::uint32_t>((column + right) * (white::kRows + 1) + row + up);
      };
      const auto outline = [&](std::size_t place) {
        const auto [right, up] = kOutline.at((left ? place : 8 - place) % 8);
        return vertex(right, up);
      };
      const auto middle = vertex(1, 1);
      for (const std::size_t corner : {0U, 2U, 4U, 6U}) {
        const auto a = outline(corner);
        triangles.insert(triangles.end(),
                         {a, outline(corner + 1), middle, a, middle, outline((corner + 7) % 8)});
      }
    }
  }
  return triangles;
}

RigidPart white_part(bool left) {
  const float side = left ? 1.0F : -1.0F;
  const glm::vec3 to_side{side, 1.0F, 1.0F};
  std::vector<glm::vec3> on_white;
  SurfaceGeometry at_rest;
  for (int column = 0; column <= white::kColumns; ++column) {
    for (int row = 0; row <= white::kRows; ++row) {
      const auto at = white::point(1.0 * column / white::kColumns, 2.0 * row / white::kRows - 1.0);
      on_white.emplace_back(at.x / kEyeRadius, at.y / kEyeRadius, -9.0);
      at_rest.positions.push_back(to_side * glm::vec3{at} + glm::vec3{centre(left)});
      at_rest.normals.push_back(to_side * white::normal(at.x, at.y));
    }
  }
  return {.carrier = Carrier::Head,
          .description = unmasked(Material::Eye, white_triangles(left), std::move(on_white)),
          .at_rest = std::move(at_rest)};
}

}  // namespace

std::vector<RigidPart> eye_parts(const Cage& cage, bool left) {
  auto unit = sphere(cage, left, 2);
  for (auto& point : unit.points) point = glm::normalize(point);
  std::vector<RigidPart> parts{ball(unit, left), white_part(left), cornea(unit, left)};
  for (auto& part : parts) part.description.name = cage.name;
  return parts;
}

RigidMotion gaze(bool left, double x_deg, double y_deg) {
  return rotation_about(centre(left), rotation_about_y(x_deg) * rotation_about_x(y_deg));
}

}  // namespace bimodal::synth
