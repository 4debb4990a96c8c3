#include "synth/inspection/outside_cells.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"
#include "tests/synth/face/the_head.hpp"

namespace bimodal::synth {
namespace {

constexpr glm::vec3 kLeast{-45.0F, -105.0F, 20.0F};
constexpr glm::vec3 kMost{45.0F, -60.0F, 105.0F};

class CellsOutsideTeeth : public testing::Test {
 protected:
  CellsOutsideTeeth()
      : tree_{posed(neutral_pose()).at(HeadSurface::UpperTeeth).positions,
              the_head().surfaces()[static_cast<std::size_t>(HeadSurface::UpperTeeth)].triangles},
        cells_{tree_, kLeast, kMost} {}

  SurfaceTree tree_;
  OutsideCells cells_;
};

TEST_F(CellsOutsideTeeth, NeverHoldAPointInside) {
  Random random{7};
  std::size_t inside = 0;
  std::size_t sure = 0;
  constexpr std::size_t kPoints = 40000;
  for (std::size_t i = 0; i < kPoints; ++i) {
    glm::vec3 point{};
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      point[axis] =
          kLeast[axis] + static_cast<float>(random.uniform()) * (kMost[axis] - kLeast[axis]);
    }
    const bool is_inside = tree_.signed_distance(point, 20.0F) < 0.0F;
    inside += is_inside ? 1U : 0U;
    sure += cells_.surely_hold(point) ? 1U : 0U;
    EXPECT_FALSE(is_inside && cells_.surely_hold(point));
  }
  EXPECT_GT(inside, 200U);
  EXPECT_GT(sure, kPoints * 8 / 10);
}

TEST_F(CellsOutsideTeeth, HoldAllThatIsFarAway) {
  EXPECT_TRUE(cells_.surely_hold(kLeast - glm::vec3{1.0F}));
  EXPECT_TRUE(cells_.surely_hold(kMost + glm::vec3{3.0F}));
  EXPECT_TRUE(cells_.surely_hold(glm::vec3{std::numeric_limits<float>::max()}));
}

}  // namespace
}  // namespace bimodal::synth
