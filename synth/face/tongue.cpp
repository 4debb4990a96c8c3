#include "synth/face/tongue.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

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

/// The gap between the incisors' edges, in the frame of the jaw; heights, mm.
struct Gap {
  double lower;
  double upper;
};

Gap gap_between_teeth(const JawMotion& jaw) {
  constexpr double kLowerEdge = -75.6;
  constexpr glm::dvec3 kUpperEdge{0.0, -78.0, 92.0};
  constexpr double kClear = 0.25;
  return {.lower = kLowerEdge + kClear, .upper = jaw.undo(kUpperEdge).y - kClear};
}

/// The tongue's front finds its way: while the teeth are shut it stays behind them; where the tip
/// is to come out, it comes out between them.
class Passage {
 public:
  Passage(const JawMotion& jaw, double tip_z)
      : gap_{gap_between_teeth(jaw)},
        open_{smooth_step(kShut, kOpen, gap_.upper - gap_.lower)},
        out_{open_ * smooth_step(kBehind, kOutside, tip_z)},
        shorter_{tip_z > kBehind ? (kBehind - kFree) / (tip_z - kFree) : 1.0} {}

  void guide(glm::dvec2& point, double half_thickness) const {
    if (point.y > kFree) {
      const double shortened = kFree + (point.y - kFree) * shorter_;
      point.y += (1.0 - open_) * (shortened - point.y);
    }
    const double middle = 0.5 * (gap_.lower + gap_.upper);
    const double room = std::max(0.0, 0.5 * (gap_.upper - gap_.lower) - half_thickness);
    const double wanted = std::clamp(point.x, middle - room, middle + room);
    point.x += near_teeth(point.y) * (wanted - point.x);
  }

  [[nodiscard]] double half_thickness(double wanted, double z) const {
    const double most = std::max(0.5, 0.5 * (gap_.upper - gap_.lower));
    return wanted + near_teeth(z) * (std::min(wanted, most) - wanted);
  }

 private:
  // mm between the edges
  static constexpr double kShut = 0.6;
  static constexpr double kOpen = 1.8;
  // z in the jaw's frame
  static constexpr double kFree = 78.0;
  static constexpr double kBehind = 86.8;
  static constexpr double kOutside = 90.0;

  [[nodiscard]] double near_teeth(double z) const { return out_ * smooth_step(kFree, kBehind, z); }

  Gap gap_;
  double open_;
  double out_;
  double shorter_;
};

/// The root follows the jaw least.
void carry(const JawMotion& jaw, TongueCage& cage) {
  for (std::size_t station = 0; station < kTongueStations; ++station) {
    const auto motion = jaw.rigid(std::clamp(0.35 + 0.65 * (along(station) / 0.45), 0.0, 1.0));
    const std::size_t first = station * kTongueRound;
    const bool has_tip = station + 1 == kTongueStations;
    const std::size_t end = has_tip ? kTongueVertices : first + kTongueRound;
    for (std::size_t i = first; i < end; ++i) cage[i] = motion.move(cage[i]);
  }
}

}  // namespace

TongueCage tongue_cage(const Pose& pose, const JawMotion& jaw) {
  std::array<double, kTongueStations> half_thickness{};
  Midline midline;
  const Passage passage{jaw, midline_point(pose, 1.0).y};
  for (std::size_t i = 0; i < kTongueStations; ++i) {
    midline[i] = midline_point(pose, along(i));
    half_thickness.at(i) = passage.half_thickness(
        value(pose, Control::TongueThickness) * interpolate(along(i), kAlong, kHalfThickness),
        midline[i].y);
    passage.guide(midline[i], half_thickness.at(i));
  }

  TongueCage cage;
  for (std::size_t i = 0; i < kTongueStations; ++i) {
    const double t = along(i);
    const Section section{
        .centre = midline[i],
        .direction = direction(midline, i),
        .half_width = value(pose, Control::TongueWidth) * interpolate(t, kAlong, kHalfWidth),
        .half_thickness = half_thickness.at(i)};
    for (std::size_t j = 0; j < kTongueRound; ++j) {
      cage.at(i * kTongueRound + j) = surface_point(section, j);
    }
  }
  const auto tip = midline.back() + 2.0 * direction(midline, kTongueStations - 1);
  cage.back() = {0.0, tip.x, tip.y};

  carry(jaw, cage);
  return cage;
}

}  // namespace bimodal::synth
