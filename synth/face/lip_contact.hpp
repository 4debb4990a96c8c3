#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "synth/face/mouth_loops.hpp"

namespace bimodal::synth {

struct LipContact {
  double closure = 0.0;      ///< 0 to 1: part of the remaining gap that is closed
  double compression = 0.0;  ///< 0 to 1: lips pressed together and rolled in
  double width_mm = 0.0;     ///< change of mouth width; narrowing zips the lips from the corners
};

/// Brings facing points of the lips together as asked, and never lets them pass through each other.
/// Rings 6 to 8 coincide where the lips touch: a Catmull-Clark limit point depends on its
/// neighbours only, so the drawn middle ring of upper and lower lip are then the same and the seal
/// is exact.
void bring_lips_together(const LipContact& contact,
                         const MouthLoops& mouth,
                         std::span<glm::dvec3> skin);

}  // namespace bimodal::synth
