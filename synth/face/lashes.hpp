#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "synth/face/field_table.hpp"
#include "synth/face/surface.hpp"

namespace bimodal::synth {

class LashScatter;

/// The eyelashes: bent five-vertex blades rooted in the lid margins of the drawn skin, 58 above and
/// 34 below each eye. Their scatter comes from a fixed seed, so that every head has the same ones.
class Lashes {
 public:
  Lashes(const FieldTable& table, std::span<const glm::dvec3> rest);

  /// Where each blade's vertices are on a drawn skin whose first vertices are the cage's images.
  void place(std::span<const glm::vec3> skin, SurfaceGeometry& lashes) const;

  [[nodiscard]] SurfaceDescription description(std::span<const glm::vec3> rest_skin) const;

 private:
  static constexpr std::size_t kMargin = 20;  ///< vertices round the lid margin

  struct Lash {
    std::array<std::uint32_t, 4> margin;  ///< skin vertices before, at, after, beyond the root
    std::array<float, 4> place;           ///< Catmull-Rom weights of the root
    std::array<float, 4> along;           ///< and of the margin's direction
    glm::vec3 eye;
    glm::vec3 lean;  ///< sideways
    float length;
    bool upper;
  };

  std::vector<Lash> lashes_;

  void grow(std::span<const std::uint32_t> margin, bool left, bool upper, LashScatter& scatter);
};

}  // namespace bimodal::synth
