#include "stimuli/video/frame_reader.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"
#include "tests/stimuli/video/made_media.hpp"

namespace bimodal {
namespace {

using made_media::from_seconds;
using made_media::numbered_frames;
using made_media::seconds;

/// The number that numbered_frames() has drawn.
std::int64_t number_in(const Image& image) {
  constexpr std::size_t kBits = 10;
  std::int64_t number = 0;
  for (std::size_t bit = 0; bit < kBits; ++bit) {
    const auto x = (2 * bit + 1) * image.width / (2 * kBits);
    const auto pixel = (image.height / 2 * image.width + x) * 4;
    if (image.pixels.at(pixel) > 127) number |= std::int64_t{1} << bit;
  }
  return number;
}

/// When the ffprobe program says that the frames of a track begin, on the file's clock.
std::vector<double> probed_starts(const std::filesystem::path& file, const char* track) {
  std::istringstream lines{made_media::printed(
      std::string{"ffprobe -v error -select_streams "} + track +
      " -show_entries frame=best_effort_timestamp_time -of default=nk=1:nw=1 '" + file.string() +
      "'")};
  std::vector<double> starts;
  for (std::string line; std::getline(lines, line);) {
    try {
      starts.push_back(std::stod(line));
    } catch (const std::exception&) {  // "N/A"
      starts.push_back(-1e9);
    }
  }
  return starts;
}

struct Recording {
  std::string name;
  std::string file;
  std::string rate = "25";
  std::string options;
  std::string length = "8";
  std::string input_options = {};
};

std::ostream& operator<<(std::ostream& out, const Recording& recording) {
  return out << recording.name;
}

class EveryFrame : public made_media::MadeMedia, public ::testing::WithParamInterface<Recording> {};

TEST_P(EveryFrame, AppearsOnceInOrderAtItsTimeFromAnyStart) {
  const auto& recording = GetParam();
  const auto file =
      made(recording.file,
           recording.input_options + " " + numbered_frames(recording.rate, recording.length) + " " +
               recording.options);
  const auto times = probed_starts(file, "v:0");
  const auto sound = probed_starts(file, "a:0");
  ASSERT_GT(times.size(), 10U);
  const auto media = examine_media(file);
  ASSERT_TRUE(media.picture);
  const double first = times[0] > -1e8 ? times[0] : seconds(media.picture->start);
  const double zero = sound.empty() ? first : std::min(first, sound[0]);
  if (times[0] > -1e8) {
    EXPECT_NEAR(seconds(media.picture->start), times[0], 1e-6);
  }

  Random random{derive_seed(1, recording.name)};
  const double length = seconds(media.picture->length);
  const double fourth = times[3] > -1e8 ? times[3] - zero : 0.2;
  std::vector<double> begins{0.0, length - 0.001, fourth, fourth - 1e-6};
  for (int i = 0; i < 5; ++i) begins.push_back(random.uniform() * length);
  for (const double begin : begins) {
    FrameReader reader{file, {.span = {.start = from_seconds(begin)}}};
    std::optional<VideoFrame> before;
    Image reuse;
    int handed_out = 0;
    while (auto frame = reader.next(std::move(reuse))) {
      SCOPED_TRACE("frame " + std::to_string(frame->index) + " from " + std::to_string(begin));
      ASSERT_EQ(number_in(frame->image), frame->index);
      const auto place = static_cast<std::size_t>(frame->index);
      ASSERT_LT(place, times.size());
      if (times[place] > -1e8) {
        ASSERT_NEAR(seconds(frame->start), times[place] - zero, 2e-6);
      }
      if (before) {
        ASSERT_EQ(frame->index, before->index + 1);
        ASSERT_EQ(frame->start, before->end);
      } else {
        ASSERT_TRUE(frame->start <= from_seconds(begin) || frame->index == 0);
        ASSERT_GT(frame->end, from_seconds(begin));
      }
      ++handed_out;
      reuse = std::move(frame->image);
      before = std::move(frame);
      if (begin != 0.0 && handed_out > 40) break;
    }
    if (handed_out <= 40 || begin == 0.0) {
      ASSERT_TRUE(before);
      EXPECT_EQ(before->index, static_cast<std::int64_t>(times.size()) - 1);
      EXPECT_GT(before->end, before->start);
    }
  }
}

constexpr auto kBFrames = "-c:v libx264 -preset ultrafast -bf 3 -b_strategy 0 -g 30";
constexpr auto kUneven = "-vf \"setpts='(N+floor(N/3)+floor(N/7)*2)/FR/TB'\" -vsync vfr";

INSTANTIATE_TEST_SUITE_P(
    Of,
    EveryFrame,
    ::testing::Values(
        Recording{"H264InMp4", "a.mp4", "25", kBFrames},
        Recording{"H264InMkvAtNtscRate", "a.mkv", "30000/1001", kBFrames},
        Recording{"H264At60", "a.mp4", "60", kBFrames},
        Recording{"H264At24", "b.mkv", "24000/1001", kBFrames},
        Recording{"H264WithOpenGroups",
                  "a.mp4",
                  "50",
                  std::string{kBFrames} + " -x264-params open-gop=1:keyint=40:bframes=3"},
        Recording{"H264OfUnevenRateInMkv", "c.mkv", "30", std::string{kUneven} + " " + kBFrames},
        Recording{"H264OfUnevenRateInMp4", "c.mp4", "30", std::string{kUneven} + " " + kBFrames},
        Recording{"H264OfMoreThanAMinute", "l.mp4", "10", kBFrames, "100"},
        Recording{"H264OfUnevenRateAndMoreThanAMinute",
                  "m.mkv",
                  "10",
                  std::string{kUneven} + " " + kBFrames,
                  "80"},
        Recording{"H264InMpegTs", "a.ts", "25", kBFrames},
        Recording{"H264WithSoundThatComesFirst",
                  "d.mp4",
                  "25",
                  std::string{"-f lavfi -i sine=f=300:d=8 -c:a aac -vsync passthrough "} + kBFrames,
                  "8",
                  "-itsoffset 0.7"},
        Recording{
            "H264ThatBeginsLate", "e.mkv", "25", std::string{kBFrames} + " -output_ts_offset 3.21"},
        Recording{"Mpeg1", "a.mpg", "25", "-c:v mpeg1video -bf 2 -q:v 2"},
        Recording{"Mpeg2Interlaced",
                  "b.mpg",
                  "25",
                  "-c:v mpeg2video -flags +ildct+ilme -top 1 -bf 2 -q:v 2"},
        Recording{"Ffv1", "f.mkv", "25", "-c:v ffv1 -level 3"},
        Recording{"Vp9", "g.webm", "30", "-c:v libvpx-vp9 -deadline realtime -cpu-used 8 -g 50"},
        Recording{"MotionJpeg", "h.avi", "30", "-c:v mjpeg -q:v 3"},
        Recording{"Mpeg4WithBFramesInAvi", "i.avi", "25", "-c:v mpeg4 -bf 2 -q:v 3"},
        Recording{"H264InAviWithoutTimes", "j.avi", "25", kBFrames},
        Recording{
            "H265", "k.mp4", "25", "-c:v libx265 -preset ultrafast -x265-params log-level=none"}),
    [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace bimodal
