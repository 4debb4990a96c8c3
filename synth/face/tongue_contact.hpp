#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "synth/face/jaw.hpp"
#include "synth/face/rigid_part.hpp"
#include "synth/face/tooth_row.hpp"

namespace bimodal::synth {

/// Keeps the drawn tongue out of teeth and palate: it yields where it meets them. Its sides stay
/// within the teeth; its front passes between the incisors where the jaw leaves room, and is
/// flattened to what room there is; elsewhere it stays behind them; its back is flattened by the
/// palate.
class TongueContact {
 public:
  TongueContact(const RigidPart& upper_teeth, const RigidPart& lower_teeth);

  /// `tongue`: drawn points, before the head turns. `teeth_offset` moves both rows, mm.
  void yield_to(const JawMotion& jaw,
                const glm::dvec3& teeth_offset,
                std::span<glm::vec3> tongue) const;

 private:
  ToothRow upper_;
  ToothRow lower_;
};

}  // namespace bimodal::synth
