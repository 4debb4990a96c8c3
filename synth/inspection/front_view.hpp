#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace bimodal::synth {

/// What of the mouth is seen from straight ahead, from infinitely far (no perspective): a map of
/// the nearest surface at each place of a grid of kCell, so that areas are right to within about
/// half a cell along their outline.
class FrontView {
 public:
  static constexpr float kCell = 0.2F;  ///< mm

  /// Empty. Reused from pose to pose.
  FrontView();

  void clear();

  /// Draws a surface; `number` (below 255) tells it from the others.
  void draw(std::span<const glm::vec3> positions,
            std::span<const std::uint32_t> triangles,
            std::uint8_t number);

  /// mm2 in which a surface is seen.
  [[nodiscard]] double area_of(std::uint8_t number) const;

  /// The part of it that is farther in front than `z` mm.
  [[nodiscard]] double area_of(std::uint8_t number, double z) const;

 private:
  void draw(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, std::uint8_t number);

  std::vector<float> nearest_;
  std::vector<std::uint8_t> number_;
};

}  // namespace bimodal::synth
