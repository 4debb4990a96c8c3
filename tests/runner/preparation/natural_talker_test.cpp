// Natural video in trials: which frame is seen at each refresh, read back from the pixels of videos
// whose frames show their own number.

#include "runner/preparation/natural_talker.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/stimuli/video/made_media.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

class NaturalTalker : public made_media::MadeMedia {
 protected:
  static Enactment enactment_of(const std::filesystem::path& file, MediaSpan span) {
    Enactment enactment;
    enactment.length = span.end - span.start;
    enactment.picture_source = RecordedSource{.corpus = "test",
                                              .item = "frames",
                                              .file = file.filename(),
                                              .sha256 = "",
                                              .path = file,
                                              .span = span};
    return enactment;
  }

  /// The number that a frame shows: ten bars, the lowest bit at the left.
  static std::int64_t number_in(const Image& image) {
    std::int64_t number = 0;
    for (std::size_t bit = 0; bit < 10; ++bit) {
      const auto x = static_cast<std::size_t>((static_cast<double>(bit) + 0.5) *
                                              static_cast<double>(image.width) / 10.0);
      const auto pixel = image.pixels[(image.height / 2 * image.width + x) * 4];
      number |= static_cast<std::int64_t>(pixel > 128) << bit;
    }
    return number;
  }

  static std::vector<std::int64_t> frames_shown(const Enactment& enactment, double refresh_hz) {
    const auto talker = natural_talker(enactment, 64, Hertz{refresh_hz}, [] {});
    std::vector<std::int64_t> shown;
    const auto refreshes = static_cast<int>(made_media::seconds(enactment.length) * refresh_hz);
    for (int i = 0; i < refreshes; ++i) {
      const Duration time{std::llround(1e9 * i / refresh_hz)};
      const auto number = talker->picture_at(time);
      EXPECT_EQ(number_in(*talker->paint(time)), talker->source_frame(number)) << "refresh " << i;
      shown.push_back(*talker->source_frame(number));
    }
    return shown;
  }
};

TEST_F(NaturalTalker, ShowsTheFrameOfEachRefreshAtAnyRefreshRate) {
  const auto file = made("x.mkv", made_media::numbered_frames("25", "2") + " -c:v ffv1");
  for (const double hz : {50.0, 59.94, 60.0, 75.0, 144.0}) {
    const auto shown = frames_shown(enactment_of(file, {400ms, 1400ms}), hz);
    for (std::size_t i = 0; i < shown.size(); ++i) {
      // The frame that is on at the middle of the refresh.
      const double middle = 0.4 + (static_cast<double>(i) + 0.5) / hz;
      EXPECT_NEAR(static_cast<double>(shown[i]), std::floor(middle * 25.0), 1e-9)
          << hz << " Hz, refresh " << i;
    }
    EXPECT_EQ(shown.front(), 10);
    EXPECT_EQ(shown.back(), 34);
  }
}

TEST_F(NaturalTalker, FollowsThePresentationTimesOfAVariableFrameRate) {
  // Frames 0, 1, 2 ... at 0, 40, 80 ms, from frame 10 on at twice the distance.
  const auto file =
      made("v.mkv",
           made_media::numbered_frames("25", "2") +
               " -vf \"setpts='if(lt(N,10),N,2*N-10)*0.04/TB'\" -vsync vfr -c:v ffv1");
  const auto shown = frames_shown(enactment_of(file, {0ms, 1200ms}), 60.0);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const double middle = (static_cast<double>(i) + 0.5) / 60.0;
    const double expected = middle < 0.4 ? middle / 0.04 : (middle / 0.04 + 10.0) / 2.0;
    EXPECT_EQ(shown[i], static_cast<std::int64_t>(expected)) << "refresh " << i;
  }
}

TEST_F(NaturalTalker, AtThreeTimesTheSpeedShowsEveryThirdFrameAsLongAsBefore) {
  const auto file = made("x.mkv", made_media::numbered_frames("25", "4") + " -c:v ffv1");
  auto enactment = enactment_of(file, {400ms, 2800ms});
  enactment.rate = 3.0;
  enactment.length /= 3;
  const auto shown = frames_shown(enactment, 50.0);
  ASSERT_EQ(shown.size(), 40U);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_EQ(shown[i], 10 + 3 * static_cast<std::int64_t>(i / 2)) << "refresh " << i;
  }
}

// Wherever between two frames the item begins.
TEST_F(NaturalTalker, KeepsFramesAtTheirTimesAtAnyRate) {
  const auto file = made("x.mkv", made_media::numbered_frames("25", "4") + " -c:v ffv1");
  for (const double rate : {0.25, 0.5, 0.8, 1.0, 2.0, 3.0}) {
    for (const auto start : {400ms, 415ms, 439ms}) {
      auto enactment = enactment_of(file, {start, start + 1200ms});
      enactment.rate = rate;
      enactment.length = Duration{std::llround(1.2e9 / rate)};
      const double step = std::max(rate, 1.0);
      const auto shown = frames_shown(enactment, 60.0);
      for (std::size_t i = 0; i < shown.size(); ++i) {
        const double middle = (static_cast<double>(i) + 0.5) / 60.0;
        const double frames_since = (made_media::seconds(start) - 0.4 + rate * middle) * 25.0;
        if (std::abs(frames_since - std::round(frames_since)) < 1e-3) continue;  // either
        const auto expected =
            10 + static_cast<std::int64_t>(std::floor(frames_since / step) * step);
        EXPECT_EQ(shown[i], expected)
            << "rate " << rate << ", " << start.count() << ", refresh " << i;
      }
    }
  }
}

TEST_F(NaturalTalker, RunsBackwardsThreeTimesAsFast) {
  const auto file = made("x.mkv", made_media::numbered_frames("25", "4") + " -c:v ffv1");
  auto enactment = enactment_of(file, {400ms, 1600ms});
  enactment.rate = 3.0;
  enactment.length /= 3;
  enactment.reversed = true;
  const auto shown = frames_shown(enactment, 50.0);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_EQ(shown[i], 39 - 3 * static_cast<std::int64_t>(i / 2)) << "refresh " << i;
  }
}

TEST_F(NaturalTalker, RunsBackwards) {
  const auto file = made("x.mkv", made_media::numbered_frames("25", "2") + " -c:v ffv1");
  auto enactment = enactment_of(file, {400ms, 1400ms});
  enactment.reversed = true;
  const auto shown = frames_shown(enactment, 50.0);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_EQ(shown[i], 34 - static_cast<std::int64_t>(i / 2)) << "refresh " << i;
  }
}

TEST_F(NaturalTalker, RestsBeforeAndAfterItsRecording) {
  const auto file = made("x.mkv", made_media::numbered_frames("25", "2") + " -c:v ffv1");
  auto enactment = enactment_of(file, {400ms, 800ms});
  enactment.length = 800ms;
  enactment.picture_start = 200ms;  // of a longer sound
  const auto shown = frames_shown(enactment, 50.0);
  EXPECT_EQ(shown.front(), 10);
  EXPECT_EQ(shown[9], 10);
  EXPECT_EQ(shown[12], 11);
  EXPECT_EQ(shown.back(), 19);
}

TEST_F(NaturalTalker, WhoDoesNotFitIntoMemoryIsRefused) {
  const auto file = made("x.mp4", "-f lavfi -i color=s=64x36:r=60:d=20 -c:v mpeg4");
  EXPECT_THAT(
      made_media::message_of([&] {
        static_cast<void>(natural_talker(enactment_of(file, {0s, 20s}), 2160, Hertz{60}, [] {}));
      }),
      testing::HasSubstr("does not fit into memory"));
}

}  // namespace
}  // namespace bimodal::runner
