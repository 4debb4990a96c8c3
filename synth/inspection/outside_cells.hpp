#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "synth/face/surface_tree.hpp"

namespace bimodal::synth {

/// Which places surely lie outside a closed surface that does not move: most points that are asked
/// for need no search in its tree then. A cell of a cubic mm is outside if no part of the surface
/// reaches into it and a way through such cells leads to it from far away, so that bodies which
/// overlap, as neighbouring teeth do, are judged rightly.
class OutsideCells {
 public:
  /// `least` and `most`: corners of a box that holds the whole surface, mm.
  OutsideCells(const SurfaceTree& surface, const glm::vec3& least, const glm::vec3& most);

  /// Never true for a point inside; false for some outside.
  [[nodiscard]] bool surely_hold(const glm::vec3& point) const;

 private:
  using Cell = std::array<std::size_t, 3>;

  [[nodiscard]] std::size_t index(const Cell& cell) const {
    return (cell[2] * size_[1] + cell[1]) * size_[0] + cell[0];
  }

  [[nodiscard]] std::vector<bool> empty_cells(const SurfaceTree& surface) const;
  void spread_from_the_border(const std::vector<bool>& empty);

  glm::vec3 least_;
  Cell size_{};
  std::vector<bool> outside_;
};

}  // namespace bimodal::synth
