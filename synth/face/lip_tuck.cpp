#include "synth/face/lip_tuck.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "synth/face/dental_arch.hpp"
#include "synth/face/smoothing.hpp"

namespace bimodal::synth {

namespace {

constexpr double kRollDegrees = 46.0;
// The lower vermilion border, the axis of the roll, by distance from the midline.
constexpr std::array<double, 4> kBorderX{0.0, 10.0, 18.0, 25.0};
constexpr std::array<double, 4> kBorderY{-87.0, -86.0, -82.5, -77.0};
constexpr std::array<double, 4> kBorderZ{99.3, 97.5, 93.0, 85.0};

// How far rings 1 to 9 follow the contact ring 6 to the teeth.
constexpr std::array<double, 10> kFollowing{0.0, 0.14, 0.34, 0.58, 0.80, 1.0, 1.0, 1.0, 1.0, 0.6};
constexpr int kContactRing = 6;

/// The edge of the upper teeth opposite a point of the lower lip, 1.25 mm in front of
/// the arch, which their faces overhang by nearly as much.
glm::dvec3 incisal_edge(double x) {
  const double lateral = std::abs(x);
  return {x,
          -76.4 + 0.033 * std::pow(std::max(0.0, lateral - 6.0), 1.2),
          kUpperArch.z_at(std::min(lateral, 25.0)) + 1.25};
}

}  // namespace

LipTuck::LipTuck(const FieldTable& table, std::span<const glm::dvec3> rest) {
  const auto weights = table.column("tuck");
  weight_.assign(weights.begin(), weights.end());
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (weight_[i] == 0.0) continue;
    const double x = std::abs(rest[i].x);
    rolled_.push_back({.vertex = i,
                       .weight = weight_[i],
                       .axis_y = interpolate(x, kBorderX, kBorderY),
                       .axis_z = interpolate(x, kBorderX, kBorderZ)});
  }
}

void LipTuck::roll(double tuck, std::span<glm::dvec3> skin) const {
  if (tuck == 0.0) return;
  for (const auto& [vertex, weight, axis_y, axis_z] : rolled_) {
    const double angle = glm::radians(kRollDegrees * tuck) * weight;
    auto& point = skin[vertex];
    const double y = point.y - axis_y;
    const double z = point.z - axis_z;
    point.y = axis_y + y * std::cos(angle) + z * std::sin(angle);
    point.z = axis_z + z * std::cos(angle) - y * std::sin(angle);
  }
}

void LipTuck::carry(double tuck, const MouthLoops& mouth, std::span<glm::dvec3> skin) const {
  if (tuck == 0.0) return;
  using enum MouthLoops::Side;
  for (int column = MouthLoops::kCorner + 1; column < MouthLoops::kColumns; ++column) {
    for (const auto side : {Left, Right}) {
      if (side == Right && column == MouthLoops::kColumns - 1) continue;
      const auto contact = mouth.vertex(kContactRing, column, side);
      const auto way = (incisal_edge(skin[contact].x) - skin[contact]) * tuck * weight_[contact];
      for (int ring = MouthLoops::kFirstRing; ring <= MouthLoops::kLastRing; ++ring) {
        skin[mouth.vertex(ring, column, side)] +=
            way * kFollowing.at(static_cast<std::size_t>(ring));
      }
    }
  }
}

}  // namespace bimodal::synth
