#include "synth/inspection/front_view.hpp"

#include <array>

#include <gtest/gtest.h>

namespace bimodal::synth {
namespace {

constexpr std::array<std::uint32_t, 6> kSquare{0, 1, 2, 0, 2, 3};

std::vector<glm::vec3> square(float left, float bottom, float side, float z) {
  return {{left, bottom, z},
          {left + side, bottom, z},
          {left + side, bottom + side, z},
          {left, bottom + side, z}};
}

TEST(FrontView, MeasuresAnAreaByItsOutline) {
  FrontView view;
  view.draw(square(-3, -80, 6, 90), kSquare, 1);
  EXPECT_NEAR(view.area_of(1), 36, 1.5);
}

TEST(FrontView, SeesOnlyWhatIsInFront) {
  FrontView view;
  view.draw(square(-3, -80, 6, 95), kSquare, 1);
  view.draw(square(-5, -82, 10, 90), kSquare, 2);
  EXPECT_NEAR(view.area_of(1), 36, 1.5);
  EXPECT_NEAR(view.area_of(2), 64, 2.5);
}

TEST(FrontView, TellsHowMuchIsFartherInFrontThanADepth) {
  FrontView view;
  const std::vector<glm::vec3> slope{{-5, -85, 80}, {5, -85, 80}, {5, -75, 100}, {-5, -75, 100}};
  view.draw(slope, kSquare, 3);
  EXPECT_NEAR(view.area_of(3, 90), 50, 2);
  EXPECT_NEAR(view.area_of(3), 100, 3);
}

TEST(FrontView, LooksFromWhicheverSideATriangleTurns) {
  FrontView view;
  constexpr std::array<std::uint32_t, 6> kTurned{0, 2, 1, 0, 3, 2};
  view.draw(square(-3, -80, 6, 90), kTurned, 1);
  EXPECT_NEAR(view.area_of(1), 36, 1.5);
}

TEST(FrontView, ForgetsWhenCleared) {
  FrontView view;
  view.draw(square(-3, -80, 6, 90), kSquare, 1);
  view.clear();
  EXPECT_EQ(view.area_of(1), 0);
}

TEST(FrontView, LeavesOutWhatLiesBesideItsField) {
  FrontView view;
  view.draw(square(-100, -80, 20, 90), kSquare, 1);
  view.draw(square(0, -500, 20, 90), kSquare, 1);
  EXPECT_EQ(view.area_of(1), 0);
}

}  // namespace
}  // namespace bimodal::synth
