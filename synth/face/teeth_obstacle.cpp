#include "synth/face/teeth_obstacle.hpp"

#include <algorithm>
#include <cmath>

#include "synth/face/dental_arch.hpp"
#include "synth/face/mouth_loops.hpp"
#include "synth/face/smoothing.hpp"

namespace bimodal::synth {

namespace {

constexpr int kFirstInnerRing = 6;
constexpr double kArchEnd = 27.0;        // mm from the midline
constexpr double kUpperClearance = 0.7;  // mm before the teeth
constexpr double kLowerClearance = 0.8;

}  // namespace

TeethObstacle::TeethObstacle(const FieldTable& table) {
  const auto ring = table.whole_numbers("mouth_ring");
  const auto column = table.whole_numbers("mouth_column");
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] >= kFirstInnerRing && ring[i] <= MouthLoops::kLastRing) {
      inside_.push_back({.vertex = i, .lower = column[i] >= MouthLoops::kCorner});
    }
  }
}

void TeethObstacle::push_lips_out(const JawMotion& jaw, std::span<glm::dvec3> skin) const {
  const RigidMotion out_of_jaw = jaw.rigid();
  const RigidMotion into_jaw = out_of_jaw.inverse();
  for (const auto& [vertex, lower] : inside_) {
    auto& point = skin[vertex];
    const double x = std::min(std::abs(point.x), kArchEnd);
    const double upper_z = kUpperArch.z_at(x) + kUpperClearance;
    point.z += smooth_step(-78.5, -76.8, point.y) * std::max(0.0, upper_z - point.z);
    if (!lower) continue;
    auto in_jaw = into_jaw.move(point);
    const double lower_z = kLowerArch.z_at(x) + kLowerClearance;
    const double way = smooth_step(-74.0, -76.5, in_jaw.y) * std::max(0.0, lower_z - in_jaw.z);
    if (way <= 0.0) continue;
    in_jaw.z += way;
    point = out_of_jaw.move(in_jaw);
  }
}

}  // namespace bimodal::synth
