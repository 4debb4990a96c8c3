#include "runner/devices/patched_display.hpp"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/booth/patch.hpp"
#include "runner/devices/simulated/simulated_display.hpp"
#include "tests/runner/realtime/count_allocations.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

constexpr std::array<float, 3> kRest{0.0F, 0.0F, 0.0F};
constexpr std::array<float, 3> kZero{1.0F, 1.0F, 1.0F};

class PatchedDisplayTest : public testing::Test {
 protected:
  PatchedDisplayTest() {
    display_.observe([this](const Screen& screen, const Presentation&) {
      marks_ = screen.marks.size();
      if (!screen.marks.empty()) colours_.push_back(screen.marks.back().colour);
    });
  }

  void present(bool at_zero = false) {
    Screen screen;
    screen.at_zero = at_zero;
    static_cast<void>(patched_.present(screen, clock_.now()));
  }

  VirtualClock clock_;
  SimulatedDisplay display_{clock_};
  PatchedDisplay patched_{display_, patch_of({.length = 100ms}, 1280, 1024)};
  std::size_t marks_ = 0;
  std::vector<std::array<float, 3>> colours_;
};

TEST_F(PatchedDisplayTest, PutsThePatchAtRestOnEveryScreenAboveItsMarks) {
  present();
  EXPECT_EQ(colours_.back(), kRest);
  Screen screen;
  screen.captions = {{.text = "Look."}};
  screen.marks = {{.shape = Mark::Shape::Disc, .colour = {1.0F, 0.0F, 0.0F}}};
  static_cast<void>(patched_.present(screen, clock_.now()));
  EXPECT_EQ(colours_.back(), kRest);
  EXPECT_EQ(marks_, 2U);
  present();
  EXPECT_EQ(marks_, 1U);
}

TEST_F(PatchedDisplayTest, HasTheColourOfTimeZeroForItsLengthWhateverIsShownMeanwhile) {
  present();
  colours_.clear();
  present(true);
  for (int more = 0; more < 9; ++more) present();
  const std::vector<std::array<float, 3>> six_of_60_hz{
      kZero, kZero, kZero, kZero, kZero, kZero, kRest, kRest, kRest, kRest};
  EXPECT_EQ(colours_, six_of_60_hz);
}

TEST_F(PatchedDisplayTest, GoesBackToRestWhenRefreshesAreMissed) {
  present(true);
  display_.drop_next(20);
  present();  // expected in time, and late
  present();
  EXPECT_EQ(colours_.back(), kRest);
  present(true);
  EXPECT_EQ(colours_.back(), kZero);
}

TEST_F(PatchedDisplayTest, SaysSoInItsDescription) {
  EXPECT_THAT(patched_.description(),
              testing::EndsWith("; with a patch for a photodiode, 60 pixels in the upper left "
                                "corner, white on black"));
  EXPECT_EQ(patched_.kind(), display_.kind());
}

TEST_F(PatchedDisplayTest, AllocatesNothingBetweenPicturesOfAStimulus) {
  display_.observe({});
  Screen screen;
  screen.fixation = true;
  static_cast<void>(patched_.present(screen, clock_.now()));
  const auto before = allocations_of_this_thread();
  for (int refresh = 0; refresh < 50; ++refresh) {
    screen.at_zero = refresh == 20;
    static_cast<void>(patched_.present(screen, clock_.now()));
  }
  EXPECT_EQ(allocations_of_this_thread(), before);
}

/// The pixels that a mark covers, as they are drawn: places and sizes rounded, halves down.
std::array<long, 4> pixels(const Mark& mark, int width, int height) {
  const auto w = std::lround(mark.width * width);
  const auto h = std::lround(mark.height * height);
  return {std::lround(mark.centre_x * width) - w / 2,
          std::lround(mark.centre_y * height) - h / 2,
          w,
          h};
}

TEST(PatchMark, CoversExactlyThePixelsOfItsBox) {
  for (const int size : {4, 41, 60, 77, 500}) {
    for (const auto corner : {protocols::Corner::UpperLeft, protocols::Corner::LowerRight}) {
      const protocols::Photodiode wanted{.corner = corner, .size = size};
      const auto box = protocols::patch_box(wanted, 1366, 768);
      const auto patch = patch_of(wanted, 1366, 768);
      const std::array<long, 4> expected{box.left, box.top, box.width, box.height};
      EXPECT_EQ(pixels(patch.at_rest, 1366, 768), expected);
      EXPECT_EQ(pixels(patch.at_zero, 1366, 768), expected);
    }
  }
}

TEST(PatchMark, TakesItsColoursFromThePolarity) {
  const auto patch = patch_of({.polarity = protocols::Polarity::BlackOnWhite}, 1280, 1024);
  EXPECT_EQ(patch.at_rest.colour, kZero);  // white at rest
  EXPECT_EQ(patch.at_zero.colour, kRest);
}

}  // namespace
}  // namespace bimodal::runner
