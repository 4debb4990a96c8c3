#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "synth/face/field_table.hpp"
#include "synth/face/mouth_loops.hpp"
#include "synth/face/surface.hpp"

namespace bimodal::synth {

/// Measures the lips on the drawn skin, before the head turns.
///
/// The opening at each column is the smallest vertical gap between facing points of rings 5 to 8;
/// gaps under 0.001 mm count as closed. Its width is where the gap exceeds 0.6 mm, its area the
/// integral of the gap from corner to corner.
class LipRuler {
 public:
  /// `rest` is the drawn skin at rest, from which protrusion and chin drop count.
  LipRuler(const FieldTable& table, const MouthLoops& mouth, std::span<const glm::vec3> rest);

  [[nodiscard]] LipMeasures measure(const MouthLoops& mouth, std::span<const glm::vec3> skin) const;

 private:
  /// Mean of both corners, the right one mirrored.
  [[nodiscard]] static glm::vec3 corner(const MouthLoops& mouth, std::span<const glm::vec3> skin);

  std::size_t chin_ = 0;
  float rest_upper_z_ = 0.0F;
  float rest_lower_z_ = 0.0F;
  float rest_chin_y_ = 0.0F;
  glm::vec3 rest_corner_{};
};

}  // namespace bimodal::synth
