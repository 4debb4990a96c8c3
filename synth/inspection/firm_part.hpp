#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "synth/face/surface_tree.hpp"
#include "synth/inspection/outside_cells.hpp"

namespace bimodal::synth {

/// A closed part of the head that keeps its form (a row of teeth), in the frame in which it rests.
class FirmPart {
 public:
  static constexpr float kDeepest = 6.0F;  ///< mm; nothing lies deeper in anything

  /// Triangles counter-clockwise seen from outside; not empty.
  FirmPart(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles);

  /// mm by which a point lies inside, at most kDeepest; 0 outside.
  [[nodiscard]] float depth(const glm::vec3& point) const;

  [[nodiscard]] const SurfaceTree& tree() const { return tree_; }

 private:
  SurfaceTree tree_;
  OutsideCells outside_;
};

}  // namespace bimodal::synth
