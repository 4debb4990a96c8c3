#include "synth/face/lids.hpp"

#include <algorithm>
#include <cmath>

#include "synth/face/eyeball.hpp"

namespace bimodal::synth {

namespace {

/// How far in front of the eyeball a ring slides, mm; farther as the lid closes over the cornea.
double standing_off(int ring, double closure, bool upper) {
  if (ring == 3) return upper ? 1.3 + 0.8 * closure : 1.7;
  if (ring == 4) return 1.35 + 0.6 * std::max(closure, 0.0);
  return 0.15 + 0.5 * std::max(closure, 0.0);
}

}  // namespace

Lids::Lids(const FieldTable& table, std::span<const glm::dvec3> rest) {
  const auto ring = table.whole_numbers("eye_ring");
  const auto travel = table.column("lid_travel");
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (travel[i] == 0.0) continue;
    (rest[i].x > 0.0 ? left_ : right_).push_back({i, ring[i], travel[i]});
  }
}

void Lids::close(double left, double right, std::span<glm::dvec3> skin) const {
  close_eye(left, left_, skin);
  close_eye(right, right_, skin);
}

void Lids::close_eye(double closure, std::span<const LidVertex> lids, std::span<glm::dvec3> skin) {
  if (closure == 0.0) return;
  const double onto_ball = std::min(1.0, 2.0 * std::abs(closure));
  for (const auto& [vertex, ring, travel] : lids) {
    auto& point = skin[vertex];
    const bool upper = travel < 0.0;
    point.y += travel * (upper ? closure : std::max(closure, 0.0));
    if (ring < 3 || ring > 5) continue;
    const double away =
        std::hypot(std::abs(point.x) - kLeftEyeCentre.x, point.y - kLeftEyeCentre.y);
    const double ball =
        kLeftEyeCentre.z + height_round_eye(away, kEyeRadius + standing_off(ring, closure, upper));
    point.z += onto_ball * (ball - point.z);
  }
}

}  // namespace bimodal::synth
