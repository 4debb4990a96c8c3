#include "synth/face/tongue.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include "synth/face/dental_arch.hpp"
#include "synth/face/smoothing.hpp"

namespace bimodal::synth {

namespace {

// In the median plane a point is (y, z).
using Midline = std::array<glm::dvec2, kTongueStations>;

constexpr std::array<double, 6> kAlong{0.0, 0.3, 0.6, 0.8, 0.92, 1.0};
constexpr std::array<double, 6> kHalfWidth{19.0, 20.0, 17.5, 15.2, 11.6, 7.8};
constexpr std::array<double, 6> kHalfThickness{13.0, 12.5, 8.5, 5.6, 3.9, 2.7};

double bell(double distance) {
  return std::exp(-distance * distance);
}

double along(std::size_t station) {
  return static_cast<double>(station) / (kTongueStations - 1);
}

glm::dvec2 midline_point(const Pose& pose, double t) {
  // Root, body, blade, tip; the resting tip lies behind the lower incisors.
  const double longer = value(pose, Control::TongueLength);
  const double u = 1.0 - t;
  glm::dvec2 point = u * u * u * glm::dvec2{-104.0, 32.0} +
                     3.0 * u * u * t * glm::dvec2{-80.0, 36.0} +
                     3.0 * u * t * t * glm::dvec2{-75.5, 58.0 + 0.45 * longer} +
                     t * t * t * glm::dvec2{-80.5, 83.5 + longer};
  point.x += value(pose, Control::TongueBack) * bell((t - 0.42) / 0.24);

  // Turned about the root.
  const double angle =
      glm::radians(value(pose, Control::TongueAngle)) * std::clamp((t - 0.15) / 0.85, 0.0, 1.0);
  constexpr glm::dvec2 kRoot{-94.0, 46.0};
  const auto arm = point - kRoot;
  point = kRoot + glm::dvec2{arm.x * std::cos(angle) + arm.y * std::sin(angle),
                             arm.y * std::cos(angle) - arm.x * std::sin(angle)};

  // The tip curled up and, in doing so, back.
  const double curl = value(pose, Control::TongueTip);
  const double near_tip = std::clamp((t - 0.55) / 0.45, 0.0, 1.0);
  point.x += curl * std::pow(near_tip, 1.6);
  point.y -= 0.018 * curl * std::abs(curl) * near_tip * near_tip;
  return point;
}

/// Unit direction towards the tip.
glm::dvec2 direction(const Midline& midline, std::size_t station) {
  const auto before = station == 0 ? 0 : station - 1;
  const auto after = std::min(station + 1, kTongueStations - 1);
  return glm::normalize(midline.at(after) - midline.at(before));
}

double signed_power(double base, double exponent) {
  return std::copysign(std::pow(std::abs(base), exponent), base);
}

/// Draws a point in, so that the tongue lies inside the lower teeth where it is low enough.
void keep_inside_lower_arch(glm::dvec3& point) {
  if (point.z >= 85.5) return;
  constexpr std::array<double, 4> kZ{45.0, 60.0, 78.0, 87.0};
  constexpr std::array<double, 4> kTeethAndMargin{8.0, 7.5, 6.0, 3.5};
  const double limit =
      std::max(6.0, kLowerArch.half_width_at(point.z) - interpolate(point.z, kZ, kTeethAndMargin));
  const double low = 1.0 - smooth_step(-76.5, -73.5, point.y);
  point.x -= std::copysign(std::max(0.0, std::abs(point.x) - limit) * low, point.x);
}

void keep_below_palate(glm::dvec3& point) {
  if (point.z >= 88.0) return;
  constexpr std::array<double, 6> kZ{30.0, 45.0, 62.0, 79.0, 87.0, 89.0};
  constexpr std::array<double, 6> kPalate{-70.0, -61.5, -60.0, -63.5, -68.5, -76.0};
  point.y = std::min(point.y, interpolate(point.z, kZ, kPalate) - 0.012 * point.x * point.x);
}

struct Section {
  glm::dvec2 centre;
  glm::dvec2 direction;
  double half_width;
  double half_thickness;
};

glm::dvec3 surface_point(const Section& section, std::size_t round) {
  const double phase = 2.0 * std::numbers::pi * static_cast<double>(round) / kTongueRound;
  const double x = section.half_width * signed_power(std::cos(phase), 0.8);
  const double s = std::sin(phase);
  const bool upper = s > 0.0;
  double height =
      section.half_thickness * (upper ? 0.95 * std::pow(s, 0.8) : -std::pow(std::abs(s), 0.9));
  if (upper) height -= 0.13 * section.half_thickness * bell(x / (0.35 * section.half_width));
  return {x,
          section.centre.x + section.direction.y * height,
          section.centre.y - section.direction.x * height};
}

}  // namespace

TongueCage tongue_cage(const Pose& pose, const JawMotion& jaw) {
  Midline midline;
  for (std::size_t i = 0; i < kTongueStations; ++i) midline[i] = midline_point(pose, along(i));

  TongueCage cage;
  for (std::size_t i = 0; i < kTongueStations; ++i) {
    const double t = along(i);
    const Section section{
        .centre = midline[i],
        .direction = direction(midline, i),
        .half_width = value(pose, Control::TongueWidth) * interpolate(t, kAlong, kHalfWidth),
        .half_thickness =
            value(pose, Control::TongueThickness) * interpolate(t, kAlong, kHalfThickness)};
    for (std::size_t j = 0; j < kTongueRound; ++j) {
      cage.at(i * kTongueRound + j) = surface_point(section, j);
    }
  }
  const auto tip = midline.back() + 2.0 * direction(midline, kTongueStations - 1);
  cage.back() = {0.0, tip.x, tip.y};

  for (std::size_t i = 0; i < kTongueVertices; ++i) {
    const double t = along(std::min(i / kTongueRound, kTongueStations - 1));
    keep_inside_lower_arch(cage[i]);
    cage[i] = jaw.move(cage[i], std::clamp(0.35 + 0.65 * (t / 0.45), 0.0, 1.0));
    keep_below_palate(cage[i]);
  }
  return cage;
}

}  // namespace bimodal::synth
