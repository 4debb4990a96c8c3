#include "synth/render/economy.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "tests/synth/face/the_head.hpp"

namespace bimodal::synth {
namespace {

constexpr glm::vec3 kFromAhead{0.0F, 0.0F, 1.0F};

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

std::map<DirectedEdge, int> edges_of(const std::vector<std::uint32_t>& triangles) {
  std::map<DirectedEdge, int> edges;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    ++edges[{triangles[i], triangles[next]}];
  }
  return edges;
}

std::set<DirectedEdge> border_of(const std::map<DirectedEdge, int>& edges) {
  std::set<DirectedEdge> border;
  for (const auto& [edge, count] : edges) {
    if (!edges.contains({edge.second, edge.first})) border.insert(edge);
  }
  return border;
}

std::set<std::uint32_t> vertices_of(const std::set<DirectedEdge>& edges) {
  std::set<std::uint32_t> vertices;
  for (const auto& [from, to] : edges) vertices.insert({from, to});
  return vertices;
}

/// Draws all surfaces without a gap (asserted); the part of all triangles that is left.
double part_drawn(Quality quality) {
  PosedHead resting;
  the_head().pose(neutral_pose(), resting);
  std::size_t before = 0;
  std::size_t after = 0;
  for (std::size_t s = 0; s < the_head().surfaces().size(); ++s) {
    const SurfaceDescription& surface = the_head().surfaces()[s];
    const auto drawn = triangles_worth_drawing(
        surface, paint(surface, Materials{}), resting.surfaces[s].normals, kFromAhead, quality);
    before += surface.triangles.size();
    after += drawn.size();

    const auto whole_border = vertices_of(border_of(edges_of(surface.triangles)));
    const auto edges = edges_of(drawn);
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1) << "surface " << s << ": two triangles face opposite ways";
    }
    // An edge with a triangle on one side only is a gap, unless the surface ends there anyway.
    for (const auto& [from, to] : border_of(edges)) {
      EXPECT_TRUE(whole_border.contains(from) && whole_border.contains(to))
          << "surface " << s << ": gap between vertices " << from << " and " << to;
    }
  }
  return static_cast<double>(after) / static_cast<double>(before);
}

TEST(Economy, DrawsTheWholeHeadWithTwoFifthsOfItsTrianglesAndWithoutAGap) {
  EXPECT_LT(part_drawn(Quality::Fast), 0.4);
}

TEST(Economy, DrawsMoreInFullQuality) {
  EXPECT_GT(part_drawn(Quality::Full), 1.2 * part_drawn(Quality::Fast));
}

TEST(Economy, KeepsTrianglesThatSubdivisionDidNotMake) {
  SurfaceDescription surface;
  surface.material = Material::Lash;
  surface.triangles = {0, 1, 2, 2, 1, 3};
  surface.rest_positions.resize(4);
  const std::vector<glm::vec3> normals(4, glm::vec3{0.0F, 0.0F, 1.0F});
  EXPECT_EQ(triangles_worth_drawing(
                surface, paint(surface, Materials{}), normals, kFromAhead, Quality::Fast),
            surface.triangles);
}

}  // namespace
}  // namespace bimodal::synth
