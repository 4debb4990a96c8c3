#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/preparation/frame_source.hpp"
#include "runner/preparation/shown_look.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using testing::Each;
using testing::ElementsAre;

/// A talker whose picture is a new one every 40 ms, frame 100 first.
class Counting final : public FrameSource {
 public:
  [[nodiscard]] std::int64_t picture_at(Duration time) override { return time / 40ms; }

  [[nodiscard]] std::shared_ptr<const Image> paint(Duration time) override {
    ++painted;
    return std::make_shared<const Image>(
        Image{.width = 4,
              .height = 2,
              .pixels = std::vector<std::uint8_t>(32, static_cast<std::uint8_t>(time / 40ms))});
  }

  [[nodiscard]] std::optional<std::int64_t> source_frame(std::int64_t number) const override {
    return 100 + number;
  }

  int painted = 0;
};

constexpr StimulusLayout kLayout{.recording = 100ms, .lead = 20ms, .trail = 30ms};

TEST(Film, DrawsEachPictureOnce) {
  Counting talker;
  const auto film = make_film(kLayout, Hertz{100}, talker, [] {});
  EXPECT_EQ(talker.painted, 3);
  EXPECT_THAT(film.source_frame_of_picture, ElementsAre(100, 101, 102));
  // Two frames of lead, ten of the recording, three of trail: 0 up to 40 ms, 1 up to 80, then 2.
  EXPECT_THAT(film.picture_of_frame, ElementsAre(0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 2));
}

TEST(Film, IsBlankFromTheGateOn) {
  Counting talker;
  const auto film = make_film(
      kLayout, Hertz{100}, talker, [] {}, Cut{.at = 30ms, .blank = true});
  constexpr auto kBlank = Film::kBlank;
  EXPECT_THAT(std::vector(film.picture_of_frame.begin(), film.picture_of_frame.begin() + 5),
              Each(0U));
  EXPECT_THAT(std::vector(film.picture_of_frame.begin() + 5, film.picture_of_frame.end()),
              Each(kBlank));
}

TEST(Film, OrFreezesThere) {
  Counting talker;
  const auto film = make_film(
      kLayout, Hertz{100}, talker, [] {}, Cut{.at = 50ms, .blank = false});
  EXPECT_THAT(film.picture_of_frame, ElementsAre(0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1));
}

TEST(Look, HoldsPicturesToItsFrameRate) {
  const auto shown =
      with_look(std::make_unique<Counting>(), {.height = 2, .lines = 2, .frame_rate = Hertz{10}});
  EXPECT_EQ(shown->picture_at(0ms), 0);
  EXPECT_EQ(shown->picture_at(99ms), 0);
  EXPECT_EQ(shown->picture_at(100ms), 2);
  EXPECT_EQ(shown->picture_at(199ms), 2);
  EXPECT_EQ(shown->picture_at(200ms), 5);
}

TEST(Look, EnlargesToItsHeight) {
  const auto shown = with_look(std::make_unique<Counting>(), {.height = 6, .lines = 2});
  const auto image = shown->paint(80ms);
  EXPECT_EQ(image->height, 6U);
  EXPECT_EQ(image->width, 12U);
  EXPECT_EQ(image->pixels[0], 2);
}

TEST(Look, OfAConditionComesFromItsOwnKeysThenTheWindow) {
  protocols::Condition condition{.visual_talker = "face"};
  protocols::Window window;
  window.face_height = 600;
  window.background = 0x102030;
  auto look = decide_look(condition, window, {});
  EXPECT_EQ(look.height, 600U);
  EXPECT_EQ(look.lines, 600U);
  EXPECT_EQ(look.background, 0x102030U);
  EXPECT_EQ(look.frame_rate, std::nullopt);
  condition.look = {
      .frame_rate = Hertz{25}, .lines = 288, .height = 500, .blur_px = 1.5, .background = 0xffffff};
  look = decide_look(condition, window, {});
  EXPECT_EQ(look.height, 500U);
  EXPECT_EQ(look.lines, 288U);
  EXPECT_EQ(look.frame_rate, Hertz{25});
  EXPECT_EQ(look.blur_px, 1.5);
  EXPECT_EQ(look.background, 0xffffffU);
}

}  // namespace
}  // namespace bimodal::runner
