#include "synth/face/tongue_contact.hpp"

#include <algorithm>

#include <glm/vec2.hpp>

#include "synth/face/palate.hpp"
#include "synth/face/smoothing.hpp"

namespace bimodal::synth {

namespace {

constexpr double kClear = 0.2;      // mm left between tongue and teeth or palate
constexpr double kTouching = 1e-6;  // mm: what has just yielded so far has yielded enough

// Only between the front teeth may the tongue come out; beside the molars never.
constexpr double kSidesEnd = 78.0;  // z, mm
constexpr double kFrontBegins = 84.0;

// From this gap between the incisors' edges on the tongue passes.
constexpr double kShutGap = 1.0;  // mm
constexpr double kOpenGap = 2.2;

constexpr glm::dvec3 kUpperEdge{0.0, -78.0, 92.0};
constexpr glm::dvec3 kLowerEdge{0.0, -75.6, 89.5};

/// Returns whether the point meets the teeth. `may_pass`: whether it may also get out of the
/// teeth's way into the gap between the jaws.
bool yield(const ToothRow& teeth, double passing, bool may_pass, glm::dvec3& point) {
  const double beyond = teeth.beyond(point.x, point.z) + kClear;
  if (beyond <= 0.0) return false;
  const auto place = teeth.at(point.x, point.z);
  const auto draw_in = [&](double way) {
    point.x += way * place.inward.x;
    point.z += way * place.inward.y;
  };
  const double front = passing * smooth_step(kSidesEnd, kFrontBegins, point.z);
  draw_in(beyond * (1.0 - front));
  const double left = beyond * front;
  const double depth = teeth.depth(place, point.y) + kClear;
  if (left <= 0.0 || depth <= kTouching) return true;
  if (may_pass && depth < left) {
    point.y += depth * teeth.into_gap();
  } else {
    draw_in(left);
  }
  return true;
}

void yield_to_palate(glm::dvec3& point) {
  if (point.z > kPalateFront || point.y < kPalateLowest - kClear) return;
  point.y = std::min(point.y, palate_y(point.x, point.z) - kClear);
}

}  // namespace

TongueContact::TongueContact(const RigidPart& upper_teeth, const RigidPart& lower_teeth)
    : upper_{upper_teeth.at_rest.positions,
             upper_teeth.description.triangles,
             ToothRow::Jaw::Upper},
      lower_{
          lower_teeth.at_rest.positions, lower_teeth.description.triangles, ToothRow::Jaw::Lower} {}

void TongueContact::yield_to(const JawMotion& jaw,
                             const glm::dvec3& teeth_offset,
                             std::span<glm::vec3> tongue) const {
  const RigidMotion out_of_jaw = jaw.rigid();
  const RigidMotion into_jaw = out_of_jaw.inverse();
  const double gap = kUpperEdge.y - out_of_jaw.move(kLowerEdge).y;
  const double passing = smooth_step(kShutGap, kOpenGap, gap);
  const auto meets_teeth = [&](bool may_pass, glm::dvec3& point) {
    auto in_jaw = into_jaw.move(point);
    const bool meets_lower = yield(lower_, passing, may_pass, in_jaw);
    if (meets_lower) point = out_of_jaw.move(in_jaw);
    return yield(upper_, passing, may_pass, point) || meets_lower;
  };
  for (auto& drawn : tongue) {
    glm::dvec3 point = glm::dvec3{drawn} - teeth_offset;
    // What one row gives way to, the other may stop.
    if (meets_teeth(true, point)) meets_teeth(false, point);
    yield_to_palate(point);
    drawn = glm::vec3{point + teeth_offset};
  }
}

}  // namespace bimodal::synth
