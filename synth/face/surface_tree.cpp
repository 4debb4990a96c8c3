#include "synth/face/surface_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace bimodal::synth {

namespace {

constexpr std::size_t kLeafTriangles = 6;

glm::vec3 unit(const glm::vec3& vector) {
  const float length = glm::length(vector);
  return length > 0.0F ? vector / length : glm::vec3{0.0F};
}

float angle_at(const glm::vec3& corner, const glm::vec3& next, const glm::vec3& last) {
  return std::acos(std::clamp(glm::dot(unit(next - corner), unit(last - corner)), -1.0F, 1.0F));
}

float squared(const glm::vec3& vector) {
  return glm::dot(vector, vector);
}

/// Squared distance from a point to a box; 0 inside.
float squared_to_box(glm::vec3 point, glm::vec3 least, glm::vec3 most) {
  return squared(glm::max(glm::max(least - point, point - most), glm::vec3{0.0F}));
}

/// The nearest point of a triangle and the feature on which it lies: 0 the face, 1 to 3 the corner
/// before, 4 to 6 the edge behind that corner.
struct OnTriangle {
  glm::vec3 point;
  int feature;
};

/// Regions of a triangle by barycentric signs (Ericson 2005, section 5.1.5).
OnTriangle nearest_on(const std::array<glm::vec3, 3>& corners, glm::vec3 point) {
  const auto& [a, b, c] = corners;
  const glm::vec3 ab = b - a;
  const glm::vec3 ac = c - a;
  const glm::vec3 ap = point - a;
  const float d1 = glm::dot(ab, ap);
  const float d2 = glm::dot(ac, ap);
  if (d1 <= 0.0F && d2 <= 0.0F) return {a, 1};
  const glm::vec3 bp = point - b;
  const float d3 = glm::dot(ab, bp);
  const float d4 = glm::dot(ac, bp);
  if (d3 >= 0.0F && d4 <= d3) return {b, 2};
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0F && d1 >= 0.0F && d3 <= 0.0F) return {a + d1 / (d1 - d3) * ab, 4};
  const glm::vec3 cp = point - c;
  const float d5 = glm::dot(ab, cp);
  const float d6 = glm::dot(ac, cp);
  if (d6 >= 0.0F && d5 <= d6) return {c, 3};
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0F && d2 >= 0.0F && d6 <= 0.0F) return {a + d2 / (d2 - d6) * ac, 6};
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0.0F && d4 - d3 >= 0.0F && d5 - d6 >= 0.0F) {
    return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), 5};
  }
  const float scale = 1.0F / (va + vb + vc);
  return {a + vb * scale * ab + vc * scale * ac, 0};
}

}  // namespace

SurfaceTree::SurfaceTree(std::span<const glm::vec3> positions,
                         std::span<const std::uint32_t> triangles) {
  std::vector<glm::vec3> corner_normals(positions.size(), glm::vec3{0.0F});
  std::unordered_map<std::uint64_t, glm::vec3> edge_normals;
  edge_normals.reserve(triangles.size() / 2);
  const auto edge = [](std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b);
  };
  for (std::size_t t = 0; t + 3 <= triangles.size(); t += 3) {
    const auto corner = [&](std::size_t i) { return positions[triangles[t + i % 3]]; };
    const glm::vec3 normal = unit(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    for (std::size_t i = 0; i < 3; ++i) {
      corner_normals[triangles[t + i]] +=
          angle_at(corner(i), corner(i + 1), corner(i + 2)) * normal;
      edge_normals[edge(triangles[t + i], triangles[t + (i + 1) % 3])] += normal;
    }
  }
  triangles_.reserve(triangles.size() / 3);
  for (std::size_t t = 0; t + 3 <= triangles.size(); t += 3) {
    Triangle triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.corners.at(i) = positions[triangles[t + i]];
      triangle.corner_normals.at(i) = corner_normals[triangles[t + i]];
      triangle.edge_normals.at(i) =
          edge_normals.at(edge(triangles[t + i], triangles[t + (i + 1) % 3]));
    }
    const auto& [a, b, c] = triangle.corners;
    triangle.face_normal = unit(glm::cross(b - a, c - a));
    triangles_.push_back(triangle);
  }
  if (triangles_.empty()) return;
  nodes_.reserve(2 * triangles_.size() / kLeafTriangles + 2);
  nodes_.emplace_back();
  split(0, 0, triangles_.size());
}

void SurfaceTree::split(std::size_t node, std::size_t first, std::size_t count) {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  glm::vec3 least{kFar};
  glm::vec3 most{-kFar};
  for (std::size_t t = first; t < first + count; ++t) {
    for (const auto& corner : triangles_[t].corners) {
      least = glm::min(least, corner);
      most = glm::max(most, corner);
    }
  }
  nodes_[node] = {
      least, most, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)};
  if (count <= kLeafTriangles) return;
  const glm::vec3 size = most - least;
  const glm::length_t axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  const auto begin = triangles_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto half = static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(begin,
                   begin + half,
                   begin + static_cast<std::ptrdiff_t>(count),
                   [axis](const Triangle& a, const Triangle& b) {
                     return a.corners[0][axis] + a.corners[1][axis] + a.corners[2][axis] <
                            b.corners[0][axis] + b.corners[1][axis] + b.corners[2][axis];
                   });
  const auto left = nodes_.size();
  nodes_.resize(left + 2);
  nodes_[node].first = static_cast<std::uint32_t>(left);
  nodes_[node].count = 0;
  split(left, first, count / 2);
  split(left + 1, first + count / 2, count - count / 2);
}

float SurfaceTree::signed_distance(glm::vec3 point, float farthest) const {
  float best = farthest * farthest;
  const Triangle* nearest = nullptr;
  OnTriangle on{};
  std::array<std::uint32_t, 64> waiting{};
  std::size_t depth = 0;
  if (!nodes_.empty()) waiting.at(depth++) = 0;
  while (depth > 0) {
    const Node& node = nodes_[waiting.at(--depth)];
    if (squared_to_box(point, node.least, node.most) >= best) continue;
    if (node.count == 0) {
      const Node& left = nodes_[node.first];
      const Node& right = nodes_[node.first + 1];
      const bool left_first = squared_to_box(point, left.least, left.most) <
                              squared_to_box(point, right.least, right.most);
      waiting.at(depth++) = node.first + (left_first ? 1 : 0);
      waiting.at(depth++) = node.first + (left_first ? 0 : 1);
      continue;
    }
    for (std::uint32_t t = node.first; t < node.first + node.count; ++t) {
      const auto candidate = nearest_on(triangles_[t].corners, point);
      const float distance = squared(point - candidate.point);
      if (distance >= best) continue;
      best = distance;
      nearest = &triangles_[t];
      on = candidate;
    }
  }
  if (nearest == nullptr) return farthest;
  const auto place = static_cast<std::size_t>(on.feature);
  const glm::vec3& normal = place == 0   ? nearest->face_normal
                            : place <= 3 ? nearest->corner_normals.at(place - 1)
                                         : nearest->edge_normals.at(place - 4);
  const float distance = std::sqrt(best);
  return glm::dot(point - on.point, normal) < 0.0F ? -distance : distance;
}

}  // namespace bimodal::synth
