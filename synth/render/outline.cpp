#include "synth/render/outline.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

namespace bimodal::synth {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // the smaller number first

/// From which edge to which the plane crosses each triangle.
class Crossings {
 public:
  Crossings(std::span<const glm::vec3> positions,
            std::span<const std::uint32_t> triangles,
            const glm::vec3& normal,
            float distance)
      : positions_{positions} {
    beyond_.reserve(positions.size());
    for (const glm::vec3& point : positions) beyond_.push_back(glm::dot(normal, point) - distance);
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) add(triangles.subspan(i).first<3>());
  }

  std::vector<Outline> joined() {
    std::vector<Outline> outlines;
    std::set<Edge> entered;
    for (const auto& [from, to] : next_) entered.insert(to);
    std::vector<Edge> open;
    for (const auto& [from, to] : next_) {
      if (!entered.contains(from)) open.push_back(from);
    }
    for (const Edge& edge : open) outlines.push_back(follow(edge));
    while (!next_.empty()) outlines.push_back(follow(next_.begin()->first));
    return outlines;
  }

 private:
  void add(std::span<const std::uint32_t, 3> triangle) {
    Edge from;
    Edge to;
    bool is_cut = false;
    for (std::size_t side = 0; side < 3; ++side) {
      const std::uint32_t a = triangle[side];
      const std::uint32_t b = triangle[(side + 1) % 3];
      if (is_beyond(a) == is_beyond(b)) continue;
      (is_beyond(a) ? from : to) = std::minmax(a, b);
      is_cut = true;
    }
    if (is_cut) next_[from] = to;
  }

  [[nodiscard]] bool is_beyond(std::uint32_t vertex) const { return beyond_[vertex] > 0.0F; }

  /// Takes the line away that begins on `edge`.
  Outline follow(Edge edge) {
    Outline outline{.points = {crossing(edge)}, .is_closed = false};
    const Edge first = edge;
    for (auto found = next_.find(edge); found != next_.end(); found = next_.find(edge)) {
      edge = found->second;
      next_.erase(found);
      outline.is_closed = edge == first;
      if (!outline.is_closed) outline.points.push_back(crossing(edge));
    }
    return outline;
  }

  [[nodiscard]] glm::vec3 crossing(const Edge& edge) const {
    const auto [a, b] = edge;
    const float part = beyond_[a] / (beyond_[a] - beyond_[b]);
    return positions_[a] + part * (positions_[b] - positions_[a]);
  }

  std::span<const glm::vec3> positions_;
  std::vector<float> beyond_;  // mm, of each vertex
  std::map<Edge, Edge> next_;
};

}  // namespace

std::vector<Outline> outlines_in(std::span<const glm::vec3> positions,
                                 std::span<const std::uint32_t> triangles,
                                 const glm::vec3& normal,
                                 float distance) {
  return Crossings{positions, triangles, normal, distance}.joined();
}

std::vector<std::vector<glm::vec3>> polygons_of(std::vector<Outline> outlines) {
  std::vector<std::vector<glm::vec3>> polygons;
  while (!outlines.empty()) {
    Outline outline = std::move(outlines.back());
    outlines.pop_back();
    while (!outline.is_closed) {
      const glm::vec3 end = outline.points.back();
      const auto gap_to = [&end](const Outline& next) {
        return next.is_closed ? std::numeric_limits<float>::max()
                              : glm::distance(end, next.points.front());
      };
      const auto nearest = std::ranges::min_element(outlines, {}, gap_to);
      outline.is_closed =
          nearest == outlines.end() || gap_to(*nearest) >= gap_to({outline.points, false});
      if (outline.is_closed) break;
      outline.points.insert(outline.points.end(), nearest->points.begin(), nearest->points.end());
      outlines.erase(nearest);
    }
    polygons.push_back(std::move(outline.points));
  }
  return polygons;
}

}  // namespace bimodal::synth
