#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace bimodal::synth {

/// Triangles in a tree of boxes: how far a point is from them, and on which side of them it lies.
/// The side is that of the angle-weighted normal at the nearest face, edge or corner (Baerentzen &
/// Aanaes 2005), so that surfaces with sharp edges are judged rightly; open surfaces have sides as
/// far as their nearest point is not on the boundary.
class SurfaceTree {
 public:
  /// Triangles counter-clockwise seen from outside. Nothing is borrowed.
  SurfaceTree(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles);

  /// mm; positive outside. Points farther than `farthest` have the distance `farthest`.
  [[nodiscard]] float signed_distance(glm::vec3 point, float farthest) const;

 private:
  struct Triangle {
    std::array<glm::vec3, 3> corners;
    glm::vec3 face_normal;
    std::array<glm::vec3, 3> corner_normals;
    std::array<glm::vec3, 3> edge_normals;  ///< [i]: between corner i and the next
  };

  struct Node {
    glm::vec3 least{};
    glm::vec3 most{};
    std::uint32_t first =
        0;  ///< leaf: of its triangles; else: the left child, the right one behind
    std::uint32_t count = 0;  ///< of triangles; 0: no leaf
  };

  void split(std::size_t node, std::size_t first, std::size_t count);

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace bimodal::synth
