#include "stimuli/video/frame_rate.hpp"

#include <gtest/gtest.h>

#include "stimuli/video/video_form.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;

TEST(FrameRate, OfFilmIsTheExactFraction) {
  EXPECT_EQ(parse_frame_rate("29.97"), (FrameRate{30'000, 1'001}));
  EXPECT_EQ(parse_frame_rate("23.976"), (FrameRate{24'000, 1'001}));
  EXPECT_EQ(parse_frame_rate("23.98"), (FrameRate{24'000, 1'001}));
  EXPECT_EQ(parse_frame_rate("59.94"), (FrameRate{60'000, 1'001}));
  EXPECT_EQ(parse_frame_rate("119.88"), (FrameRate{120'000, 1'001}));
}

TEST(FrameRate, OtherwiseIsWhatWasWritten) {
  EXPECT_EQ(parse_frame_rate("25"), (FrameRate{25, 1}));
  EXPECT_EQ(parse_frame_rate("12.5"), (FrameRate{25, 2}));
  EXPECT_EQ(parse_frame_rate("99.9"), (FrameRate{999, 10}));
  EXPECT_EQ(parse_frame_rate("60000/1001"), (FrameRate{60'000, 1'001}));
  EXPECT_EQ(parse_frame_rate("50/2"), (FrameRate{25, 1}));
  for (const auto* const text :
       {"", "0", "0.5", "-25", "1001", "nan", "inf", "25fps", "1/0", "0/1", "30/", "1e9/1"}) {
    EXPECT_EQ(parse_frame_rate(text), std::nullopt) << text;
  }
}

TEST(FrameRate, CountsTheFramesThatBeginBeforeAnInstant) {
  const FrameRate film{30'000, 1'001};
  EXPECT_EQ(film.frames_before(1001ms), 30);
  EXPECT_EQ(film.frames_before(1001.001ms), 31);
  EXPECT_EQ((FrameRate{60}.frames_before(1000ms)), 60);
  EXPECT_EQ((FrameRate{60}.frames_before(0ms)), 0);
  EXPECT_EQ((FrameRate{60}.frames_before(0.001ms)), 1);
  EXPECT_DOUBLE_EQ(film.time_of(30).count(), 1001);
}

TEST(FrameRate, OfAGifHasFramesOfWholeHundredths) {
  const auto& gif = *video_form_of("x.GIF");
  EXPECT_EQ(rate_in(gif, FrameRate{60}), FrameRate{50});
  EXPECT_EQ(rate_in(gif, FrameRate{1000}), FrameRate{50});
  EXPECT_EQ(rate_in(gif, FrameRate{25}), FrameRate{25});
  EXPECT_EQ(rate_in(gif, FrameRate{30}), (FrameRate{100, 3}));
  EXPECT_EQ(rate_in(*video_form_of("x.mp4"), FrameRate{60}), FrameRate{60});
  EXPECT_EQ(video_form_of("x.avi"), nullptr);
  EXPECT_EQ(most_frames(gif, 1024, 1024), 256);
  EXPECT_GT(most_frames(*video_form_of("x.mp4"), 1024, 1024), 1'000'000);
}

}  // namespace
}  // namespace bimodal
