#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "synth/face/obj_reader.hpp"
#include "synth/face/padded.hpp"

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

  /// The same in single precision throughout, as drawing needs it, right to 1e-4 mm.
  void apply(std::span<const Padded> cage, PaddedPoints& fine) const;

  [[nodiscard]] std::vector<float> apply(std::span<const double> cage) const;

  /// One fine vertex in double precision.
  [[nodiscard]] glm::dvec3 point(std::span<const glm::dvec3> cage, std::size_t fine_vertex) const;

  /// Every quad in two counter-clockwise triangles.
  [[nodiscard]] std::vector<std::uint32_t> triangles() const;

 private:
  struct Term {
    std::uint32_t column;
    float weight;
  };

  void sort_terms();

  std::size_t cage_size_;
  std::vector<std::uint32_t> first_;  ///< row r: entries first_[r] to first_[r + 1]
  std::vector<std::uint32_t> column_;
  std::vector<double> weight_;
  // In single precision the rows go by their length, so that the processor foresees where each
  // ends.
  std::vector<std::uint32_t> by_length_;  ///< rows
  std::vector<Term> terms_;               ///< of these rows
  std::vector<Quad> quads_;
};

}  // namespace bimodal::synth
