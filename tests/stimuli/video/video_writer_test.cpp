#include "stimuli/video/video_writer.hpp"

#include <cmath>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/picture/drawing.hpp"
#include "stimuli/video/frame_reader.hpp"
#include "tests/stimuli/video/made_media.hpp"

namespace bimodal {
namespace {

using made_media::message_of;
using ::testing::HasSubstr;

std::filesystem::path in_temp(const std::string& name) {
  return std::filesystem::path{testing::TempDir()} / name;
}

/// A grey level and a hue that tell the frame's number.
Image numbered(std::size_t frame) {
  const auto level = static_cast<std::uint8_t>(40 + 5 * frame);
  return blank_image(64, 48, {level, 128, static_cast<std::uint8_t>(230 - 5 * frame)});
}

void write_numbered(const std::filesystem::path& file, std::size_t frames, FrameRate rate) {
  VideoWriter writer{file, {.width = 64, .height = 48, .rate = rate}};
  for (std::size_t frame = 0; frame < frames; ++frame) writer.add(numbered(frame));
  writer.finish();
}

TEST(VideoWriter, WritesFramesThatReadBackInOrderTimeAndColour) {
  const auto file = in_temp("bimodal_written.mp4");
  write_numbered(file, 30, FrameRate{60});
  FrameReader reader{file, {}};
  std::size_t count = 0;
  while (const auto frame = reader.next()) {
    EXPECT_NEAR(
        std::chrono::duration<double>{frame->start}.count(), static_cast<double>(count) / 60, 1e-4);
    const auto expected = numbered(count);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      // Colours of 64 x 48 pixels are read as of television of old (BT.601) unless the file says
      // otherwise, as it does: then only the rounding of 8 bits and the encoder's are left.
      EXPECT_NEAR(frame->image.pixels[channel], expected.pixels[channel], 4) << count;
    }
    ++count;
  }
  EXPECT_EQ(count, 30);
}

TEST(VideoWriter, GivesTheSameBytesForTheSamePictures) {
  write_numbered(in_temp("bimodal_one.mp4"), 12, FrameRate{60000, 1001});
  write_numbered(in_temp("bimodal_two.mp4"), 12, FrameRate{60000, 1001});
  EXPECT_EQ(read_file(in_temp("bimodal_one.mp4")), read_file(in_temp("bimodal_two.mp4")));
}

TEST(VideoWriter, LeavesNothingWhereItWasNotFinished) {
  const auto file = in_temp("bimodal_unfinished.mp4");
  std::filesystem::remove(file);
  {
    VideoWriter writer{file, {.width = 64, .height = 48}};
    writer.add(numbered(0));
  }
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(VideoWriter, RefusesWhatItCannotWrite) {
  const auto open = [](const std::filesystem::path& file, std::size_t width) {
    return message_of([&] { VideoWriter{file, {.width = width, .height = 48}}; });
  };
  EXPECT_THAT(open(in_temp("x.avi"), 64), HasSubstr(".mp4"));
  EXPECT_THAT(open(in_temp("x.mp4"), 63), HasSubstr("63 x 48"));
  EXPECT_THAT(open("/nowhere/at/all/x.mp4", 64), HasSubstr("/nowhere/at/all/x.mp4"));
}

}  // namespace
}  // namespace bimodal
