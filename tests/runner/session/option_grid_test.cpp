#include "runner/session/option_grid.hpp"

#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

constexpr double kAspect = 1.25;

std::vector<protocols::Option> options(std::size_t count, const std::string& label = "ba") {
  return {count, protocols::Option{.label = label}};
}

TEST(OptionGrid, KeepsItsBoxesApartAndWithinTheWindowHoweverManyThereAre) {
  for (std::size_t count = 2; count <= 40; ++count) {
    for (const char* const label :
         {"b", "strongly agree", "a label that is as long as labels may be"}) {
      const auto grid = grid_of(options(count, label), kAspect);
      ASSERT_EQ(grid.boxes.size(), count);
      EXPECT_GT(grid.label_size, 0.01);
      for (std::size_t i = 0; i < count; ++i) {
        const auto& box = grid.boxes[i];
        EXPECT_GT(box.centre_x - box.width / 2, 0.0);
        EXPECT_LT(box.centre_x + box.width / 2, 1.0);
        EXPECT_GT(box.centre_y - box.height / 2, 0.3);  // below the question
        EXPECT_LT(box.centre_y + box.height / 2, 0.85);
        for (std::size_t j = 0; j < i; ++j) {
          const auto& other = grid.boxes[j];
          EXPECT_TRUE(std::abs(box.centre_x - other.centre_x) >= box.width ||
                      std::abs(box.centre_y - other.centre_y) >= box.height)
              << count << ": " << i << " and " << j;
        }
      }
    }
  }
}

TEST(OptionGrid, PutsAFewShortOptionsInOneRowInReadingOrder) {
  const auto grid = grid_of(options(4), kAspect);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(grid.boxes[i].centre_y, grid.boxes[0].centre_y);
    EXPECT_GT(grid.boxes[i].centre_x, grid.boxes[i - 1].centre_x);
  }
  EXPECT_NEAR(grid.boxes[0].centre_x + grid.boxes[3].centre_x, 1.0, 1e-9);
}

TEST(OptionGrid, PutsALastRowThatIsNotFullInTheMiddle) {
  const auto grid = grid_of(options(11), kAspect);
  const auto& last = grid.boxes.back();
  double sum = 0.0;
  double count = 0.0;
  for (const auto& box : grid.boxes) {
    if (box.centre_y != last.centre_y) continue;
    sum += box.centre_x;
    ++count;
  }
  EXPECT_NEAR(sum / count, 0.5, 1e-9);
}

TEST(OptionGrid, FindsTheBoxOfAPlaceAndNoneBetweenBoxes) {
  const auto grid = grid_of(options(2), kAspect);
  const auto& right = grid.boxes[1];
  EXPECT_EQ(box_at(grid.boxes, right.centre_x, right.centre_y), 1U);
  EXPECT_EQ(box_at(grid.boxes, 0.5, right.centre_y), std::nullopt);
  EXPECT_EQ(box_at(grid.boxes, right.centre_x, 0.05), std::nullopt);
  const std::vector<OptionBox> exact{{0.25, 0.5, 0.5, 0.5}, {0.75, 0.5, 0.5, 0.5}};
  EXPECT_EQ(box_at(exact, 0.5, 0.25), 1U);  // the left and the upper edge belong to it
  EXPECT_EQ(box_at(exact, 1.0, 0.5), std::nullopt);
  EXPECT_EQ(box_at(exact, 0.1, 0.75), std::nullopt);
}

}  // namespace
}  // namespace bimodal::runner
