#include "synth/render/outline.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace bimodal::synth {
namespace {

constexpr glm::vec3 kUp{0.0F, 1.0F, 0.0F};

/// A square tube from y = 0 to y = 2, open above and below.
struct Tube {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> triangles;

  Tube() {
    for (const float y : {0.0F, 2.0F}) {
      positions.insert(positions.end(), {{0, y, 0}, {0, y, 1}, {1, y, 1}, {1, y, 0}});
    }
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t next = (i + 1) % 4;
      triangles.insert(triangles.end(), {i, next, next + 4, i, next + 4, i + 4});
    }
  }
};

TEST(Outlines, AreClosedWhereThePlaneGoesRoundASurface) {
  const Tube tube;
  const auto outlines = outlines_in(tube.positions, tube.triangles, kUp, 1.0F);
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_TRUE(outlines[0].is_closed);
  EXPECT_EQ(outlines[0].points.size(), 8U);  // one for each edge that is crossed
  for (const auto& point : outlines[0].points) EXPECT_FLOAT_EQ(point.y, 1.0F);
}

TEST(Outlines, AreOpenWhereASurfaceEnds) {
  const Tube tube;
  const auto outlines = outlines_in(tube.positions, tube.triangles, {1.0F, 0.0F, 0.0F}, 0.5F);
  ASSERT_EQ(outlines.size(), 2U);  // the two sides of the tube
  for (const auto& outline : outlines) {
    EXPECT_FALSE(outline.is_closed);
    EXPECT_EQ(outline.points.size(), 3U);
  }
}

TEST(Outlines, ThatAreOpenEncloseOnePolygonTogether) {
  const Tube tube;
  const auto polygons =
      polygons_of(outlines_in(tube.positions, tube.triangles, {1.0F, 0.0F, 0.0F}, 0.5F));
  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_EQ(polygons[0].size(), 6U);
}

TEST(Outlines, ThatAreClosedAreAPolygonEach) {
  const std::vector<glm::vec3> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto polygons = polygons_of({{triangle, true}, {triangle, true}});
  ASSERT_EQ(polygons.size(), 2U);
  EXPECT_EQ(polygons[0], triangle);
}

TEST(Outlines, AreNoneWhereThePlaneMisses) {
  const Tube tube;
  EXPECT_TRUE(outlines_in(tube.positions, tube.triangles, kUp, 3.0F).empty());
}

}  // namespace
}  // namespace bimodal::synth
