#include "stimuli/video/video_writer.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/picture/drawing.hpp"
#include "stimuli/video/frame_reader.hpp"
#include "tests/stimuli/video/made_media.hpp"

namespace bimodal {
namespace {

using made_media::message_of;
using made_media::printed;
using ::testing::HasSubstr;

constexpr std::size_t kWidth = 64;
constexpr std::size_t kHeight = 48;

/// A grey level and a hue that tell the frame's number.
Colour colour_of(std::size_t frame) {
  return {
      static_cast<std::uint8_t>(40 + 5 * frame), 128, static_cast<std::uint8_t>(230 - 5 * frame)};
}

/// Silence, then a tone of 1 kHz from `onset` on.
Clip tone_from(double onset_s, double length_s, double rate = 48'000) {
  Clip sound{.rate = Hertz{rate}, .samples = {}};
  for (std::size_t i = 0; static_cast<double>(i) < length_s * rate; ++i) {
    const double time = static_cast<double>(i) / rate - onset_s;
    sound.samples.push_back(
        time < 0 ? 0.0F : static_cast<float>(0.5 * std::sin(2e3 * std::numbers::pi * time)));
  }
  return sound;
}

void write_numbered(const std::filesystem::path& file,
                    std::size_t frames,
                    FrameRate rate,
                    const Clip* sound = nullptr) {
  VideoWriter writer{file, {.width = kWidth, .height = kHeight, .rate = rate, .sound = sound}};
  for (std::size_t i = 0; i < frames; ++i) writer.add(blank_image(kWidth, kHeight, colour_of(i)));
  writer.finish();
}

class WrittenVideo : public made_media::MadeMedia {
 protected:
  /// One value that ffprobe tells of the stream, "v" or "a".
  [[nodiscard]] static std::string probed(const std::filesystem::path& file,
                                          const std::string& stream,
                                          const std::string& entry) {
    auto text =
        printed(fmt::format("ffprobe -v error -count_frames -select_streams {} -show_entries "
                            "stream={} -of default=nw=1:nk=1 '{}'",
                            stream,
                            entry,
                            file.string()));
    text.erase(std::find(text.begin(), text.end(), '\n'), text.end());
    return text;
  }

  /// The times of the pictures as ffprobe tells them.
  [[nodiscard]] static std::vector<double> times(const std::filesystem::path& file) {
    std::istringstream text{
        printed(fmt::format("ffprobe -v error -select_streams v -show_entries frame=pts_time -of "
                            "default=nw=1:nk=1 '{}'",
                            file.string()))};
    std::vector<double> times;
    for (double time = 0; text >> time;) times.push_back(time);
    return times;
  }

  /// The pixel in the middle of each frame, as the ffmpeg program decodes it.
  [[nodiscard]] static std::vector<Colour> middles(const std::filesystem::path& file) {
    const auto bytes = printed(
        fmt::format("ffmpeg -nostdin -v error -i '{}' -sws_flags accurate_rnd+full_chroma_int -f "
                    "rawvideo -pix_fmt rgb24 - 2>&1 < /dev/null",
                    file.string()));
    std::vector<Colour> found;
    constexpr std::size_t kFrame = kWidth * kHeight * 3;
    for (std::size_t frame = 0; (frame + 1) * kFrame <= bytes.size(); ++frame) {
      Colour colour{};
      std::memcpy(
          colour.data(), &bytes[frame * kFrame + (kHeight / 2 * kWidth + kWidth / 2) * 3], 3);
      found.push_back(colour);
    }
    return found;
  }

  [[nodiscard]] static std::vector<float> heard(const std::filesystem::path& file) {
    const auto bytes = printed(
        fmt::format("ffmpeg -nostdin -v error -i '{}' -f f32le -ac 1 -ar 48000 - 2>&1 < /dev/null",
                    file.string()));
    std::vector<float> samples(bytes.size() / sizeof(float));
    std::memcpy(samples.data(), bytes.data(), samples.size() * sizeof(float));
    return samples;
  }
};

TEST_F(WrittenVideo, HasItsFramesInOrderTimeAndColourInEveryForm) {
  for (const std::string ending : {".mp4", ".webm", ".gif"}) {
    const auto file = path("colours" + ending);
    write_numbered(file, 30, FrameRate{50});
    EXPECT_EQ(probed(file, "v", "nb_read_frames"), "30") << ending;
    EXPECT_EQ(probed(file, "v", "r_frame_rate"), "50/1") << ending;
    const auto when = times(file);
    ASSERT_EQ(when.size(), 30) << ending;
    for (std::size_t i = 0; i < when.size(); ++i) {
      // WebM counts whole milliseconds.
      EXPECT_NEAR(when[i], static_cast<double>(i) / 50, 0.6e-3) << ending;
    }
    const auto seen = middles(file);
    ASSERT_EQ(seen.size(), 30) << ending;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        // The rounding of 8 bits, the encoder's, and of a GIF the palette's.
        EXPECT_NEAR(seen[i][channel], colour_of(i)[channel], ending == ".gif" ? 12 : 5)
            << ending << " frame " << i;
      }
    }
  }
}

TEST_F(WrittenVideo, SaysWhatItsColoursMean) {
  for (const std::string ending : {".mp4", ".webm"}) {
    const auto file = path("tags" + ending);
    write_numbered(file, 3, FrameRate{50});
    for (const std::string entry : {"color_space", "color_transfer", "color_primaries"}) {
      EXPECT_EQ(probed(file, "v", entry), "bt709") << ending << ' ' << entry;
    }
    EXPECT_EQ(probed(file, "v", "color_range"), "tv") << ending;
  }
}

TEST_F(WrittenVideo, HasRatesOfFilmExactly) {
  write_numbered(path("film.mp4"), 40, FrameRate{30'000, 1'001});
  EXPECT_EQ(probed(path("film.mp4"), "v", "avg_frame_rate"), "30000/1001");
  const auto when = times(path("film.mp4"));
  ASSERT_EQ(when.size(), 40);
  EXPECT_NEAR(when.back(), 39 * 1.001 / 30, 1e-5);
  EXPECT_NEAR(std::stod(probed(path("film.mp4"), "v", "duration")), 40 * 1.001 / 30, 1e-4);
}

TEST_F(WrittenVideo, SoundBeginsWithTheFirstPictureToTheMillisecond) {
  for (const std::string ending : {".mp4", ".webm"}) {
    for (const double rate : {16'000.0, 48'000.0}) {
      const auto file = path("sound" + ending);
      const auto tone = tone_from(0.3, 0.7, rate);
      write_numbered(file, 36, FrameRate{60}, &tone);
      EXPECT_EQ(probed(file, "a", "codec_name"), ending == ".mp4" ? "aac" : "opus");
      EXPECT_NEAR(times(file).front(), 0, 1e-6) << ending;
      const auto samples = heard(file);
      // AAC ends with a whole block of 1024 samples.
      EXPECT_NEAR(static_cast<double>(samples.size()), 0.7 * 48'000, 1024) << ending;
      const auto onset =
          std::ranges::find_if(samples, [](float it) { return std::abs(it) > 0.1F; });
      EXPECT_NEAR(static_cast<double>(onset - samples.begin()) / 48, 300, 1) << ending;
    }
  }
}

TEST_F(WrittenVideo, IsTheSameForTheSamePicturesAndSound) {
  const auto tone = tone_from(0.1, 0.4);
  for (const std::string ending : {".mp4", ".webm", ".gif"}) {
    const auto* const sound = ending == ".gif" ? nullptr : &tone;
    write_numbered(path("one" + ending), 12, FrameRate{50}, sound);
    write_numbered(path("two" + ending), 12, FrameRate{50}, sound);
    EXPECT_EQ(read_file(path("one" + ending)), read_file(path("two" + ending))) << ending;
  }
}

TEST_F(WrittenVideo, IsReadBackByTheProgramItself) {
  write_numbered(path("read.mp4"), 30, FrameRate{60});
  FrameReader reader{path("read.mp4"), {}};
  std::size_t count = 0;
  while (const auto frame = reader.next()) {
    EXPECT_NEAR(
        std::chrono::duration<double>{frame->start}.count(), static_cast<double>(count) / 60, 1e-4);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      // Colours of 64 x 48 pixels are read as of television of old (BT.601) unless the file says
      // otherwise, as it does: then only the rounding of 8 bits and the encoder's are left.
      EXPECT_NEAR(frame->image.pixels[channel], colour_of(count)[channel], 4) << count;
    }
    ++count;
  }
  EXPECT_EQ(count, 30);
}

TEST_F(WrittenVideo, LeavesNothingWhereItWasNotFinished) {
  {
    VideoWriter writer{path("unfinished.mp4"), {.width = kWidth, .height = kHeight}};
    writer.add(blank_image(kWidth, kHeight, colour_of(0)));
  }
  EXPECT_TRUE(std::filesystem::is_empty(path("")));
}

TEST_F(WrittenVideo, TellsOfAPictureThatCannotBeWritten) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  // The draft's name is a link to a disk that is always full.
  const auto file = path("full.gif");
  std::filesystem::create_symlink("/dev/full", file.string() + fmt::format(".{}.part", ::getpid()));
  EXPECT_THAT(message_of([&] { write_numbered(file, 30, FrameRate{50}); }), HasSubstr("full.gif"));
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(WrittenVideo, RefusesWhatItCannotWrite) {
  const auto opened = [](const std::filesystem::path& file, const VideoOptions& options) {
    return message_of([&] { VideoWriter{file, options}; });
  };
  const VideoOptions usual{.width = kWidth, .height = kHeight};
  EXPECT_THAT(opened(path("x.avi"), usual), HasSubstr(".mp4, .webm, .gif"));
  EXPECT_THAT(opened(path("x.mp4"), {.width = 63, .height = 48}), HasSubstr("63 x 48"));
  EXPECT_THAT(opened("/nowhere/at/all/x.mp4", usual), HasSubstr("/nowhere/at/all/x.mp4"));
  const auto tone = tone_from(0, 0.1);
  auto odd = usual;
  odd.sound = &tone;
  odd.rate = FrameRate{50};
  EXPECT_THAT(opened(path("x.gif"), odd), HasSubstr("no sound"));
  EXPECT_THAT(opened(path("x.gif"), usual), HasSubstr("take 50"));
  odd = usual;
  odd.rate_factor = 52;
  EXPECT_THAT(opened(path("x.mp4"), odd), HasSubstr("from 0 to 51"));
  EXPECT_TRUE(std::filesystem::is_empty(path("")));
}

}  // namespace
}  // namespace bimodal
