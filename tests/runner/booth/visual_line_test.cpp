#include "runner/booth/visual_line.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "runner/preparation/drawn_face.hpp"
#include "stimuli/base/asset.hpp"
#include "synth/render/head_renderer.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

constexpr Duration kPeriod = 16'666'667ns;

protocols::Protocol protocol_with(std::vector<protocols::Condition> conditions) {
  protocols::Protocol made;
  made.conditions = std::move(conditions);
  made.timing.visual_line = protocols::VisualLine::Mouth;
  return made;
}

TEST(VisualLine, IsWhereThePictureIsInTheMiddleOfTheWindow) {
  EXPECT_DOUBLE_EQ(height_in_window({1000, 600}, 0.0), 0.2);
  EXPECT_DOUBLE_EQ(height_in_window({1000, 600}, 0.5), 0.5);
  EXPECT_DOUBLE_EQ(height_in_window({1000, 600}, 1.0), 0.8);
}

TEST(VisualLine, IsDrawnAfterItsPartOfTheRefresh) {
  EXPECT_EQ(drawn_after(0.0, kPeriod), 0ns);
  EXPECT_EQ(drawn_after(0.5, 10ms), 5ms);
}

TEST(VisualLine, IsTheFirstOneUnlessTheProtocolSaysOtherwise) {
  auto protocol = protocol_with({{.name = "v", .visual_talker = "face"}});
  protocol.timing = {};
  const auto line = visual_line_of(protocol, {}, 1024, kPeriod);
  EXPECT_EQ(line.name, "first");
  EXPECT_EQ(line.after, 0ns);
}

TEST(VisualLine, OfTheMouthIsAboutTenMillisecondsAfterTheFirstOne) {
  const auto line = visual_line_of(protocol_with({{.name = "a", .auditory_talker = "festival:kal"},
                                                  {.name = "v", .visual_talker = "face"}}),
                                   {},
                                   1024,
                                   kPeriod);
  EXPECT_EQ(line.name, "mouth");
  EXPECT_GT(line.after, 9'900us);  // 10.1 ms: 61 % of the screen's height
  EXPECT_LT(line.after, 10'300us);
}

TEST(VisualLine, IsTheMeanOfConditionsWhoseMouthsAreAtDifferentHeights) {
  protocols::Condition high{.name = "high", .visual_talker = "face"};
  high.look.height = 256;
  protocols::Condition low{.name = "low", .visual_talker = "face"};
  low.look.height = 1024;
  const auto after = [](std::vector<protocols::Condition> conditions) {
    return visual_line_of(protocol_with(std::move(conditions)), {}, 1024, kPeriod).after;
  };
  EXPECT_LT(after({high}), after({low}));
  EXPECT_LE(std::chrono::abs(after({high, low}) - (after({high}) + after({low})) / 2), 1ns);
}

TEST(VisualLine, IsTheFirstOneWhereNobodyIsSeen) {
  const auto protocol = protocol_with({{.name = "a", .auditory_talker = "festival:kal"}});
  EXPECT_EQ(visual_line_of(protocol, {}, 1024, kPeriod).name, "first");
}

TEST(MouthHeight, IsTwoThirdsInRecordings) {
  EXPECT_DOUBLE_EQ(mouth_height({.name = "n", .visual_talker = "corpus:x"}), 2.0 / 3.0);
}

/// The rows of the picture between which anything but the background is, as parts of its height.
std::pair<double, double> drawn_rows(const protocols::Face& face) {
  constexpr std::size_t kLines = 360;
  const synth::Head head{asset("synth/assets/head")};
  synth::HeadRenderer renderer{
      head, view_of(face, kLines, 0xff00ff), appearance_of(face, synth::Quality::Fast)};
  Image image;
  renderer.draw({}, image);
  std::size_t first = image.height;
  std::size_t last = 0;
  for (std::size_t y = 0; y < image.height; ++y) {
    for (std::size_t x = 0; x < image.width; ++x) {
      const auto at = 4 * (y * image.width + x);
      const bool is_background = image.pixels[at] > 250 && image.pixels[at + 1] < 5;
      if (is_background) continue;
      first = std::min(first, y);
      last = std::max(last, y);
    }
  }
  return {static_cast<double>(first) / kLines, static_cast<double>(last + 1) / kLines};
}

// The lips alone, as they are drawn: the constant in the code is that of the head that ships.
TEST(MouthHeight, OfTheFaceIsWhereItsLipsAreDrawn) {
  for (const char* const view : {"front", "threequarter", "side", "mouth"}) {
    protocols::Face lips;
    lips.view = view;
    lips.show = {"lips"};
    const auto [top, bottom] = drawn_rows(lips);
    const auto mouth = mouth_height({.name = "v", .visual_talker = "face", .face = lips});
    EXPECT_LT(bottom - top, 0.3) << view;
    EXPECT_NEAR(mouth, 0.5 * (top + bottom), 0.15 * (bottom - top)) << view;
  }
}

}  // namespace
}  // namespace bimodal::runner
