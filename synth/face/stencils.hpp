#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "synth/face/obj_reader.hpp"

namespace bimodal::synth {

/// Catmull-Clark subdivision (Catmull & Clark 1978) of a fixed topology as one sparse matrix: each
/// fine vertex is a fixed weighted mean of cage vertices. Boundaries are cubic B-splines. The first
/// `cage_size` fine vertices are the images of the cage vertices, in their order.
class Stencils {
 public:
  using Quad = std::array<std::uint32_t, 4>;

  /// Throws Error if a face does not fit a surface (an edge with more than two faces, or faces of
  /// opposite orientation side by side).
  Stencils(std::size_t cage_size, std::span<const Face> faces, int levels);

  [[nodiscard]] std::size_t cage_size() const { return cage_size_; }

  [[nodiscard]] std::size_t fine_size() const { return first_.size() - 1; }

  [[nodiscard]] std::span<const Quad> quads() const { return quads_; }

  [[nodiscard]] std::size_t weight_count() const { return weight_.size(); }

  /// `cage` has cage_size() points, `fine` is made to hold fine_size().
  void apply(std::span<const glm::dvec3> cage, std::vector<glm::vec3>& fine) const;

  [[nodiscard]] std::vector<float> apply(std::span<const double> cage) const;

  /// One fine vertex in double precision.
  [[nodiscard]] glm::dvec3 point(std::span<const glm::dvec3> cage, std::size_t fine_vertex) const;

  /// Every quad in two counter-clockwise triangles.
  [[nodiscard]] std::vector<std::uint32_t> triangles() const;

 private:
  std::size_t cage_size_;
  std::vector<std::uint32_t> first_;  ///< row r: entries first_[r] to first_[r + 1]
  std::vector<std::uint32_t> column_;
  std::vector<double> weight_;
  std::vector<Quad> quads_;
};

/// Area-weighted vertex normals of unit length: the cross products of the quads' diagonals, summed.
void quad_normals(std::span<const glm::vec3> positions,
                  std::span<const Stencils::Quad> quads,
                  std::vector<glm::vec3>& normals);

}  // namespace bimodal::synth
