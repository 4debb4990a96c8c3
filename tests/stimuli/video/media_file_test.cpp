#include "stimuli/video/media_file.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/random.hpp"
#include "stimuli/video/frame_reader.hpp"
#include "stimuli/video/sound_track.hpp"
#include "tests/stimuli/video/made_media.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;
using made_media::from_seconds;
using made_media::message_of;
using made_media::numbered_frames;
using made_media::seconds;
using ::testing::AllOf;
using ::testing::HasSubstr;

class MediaFile : public made_media::MadeMedia {
 protected:
  [[nodiscard]] std::string refusal(const std::filesystem::path& file) const {
    return message_of([&] { (void)examine_media(file); });
  }
};

TEST(GridCorpus, IsReadWholly) {
  const auto* data = std::getenv("BIMODAL_TEST_DATA");
  const auto clip = std::filesystem::path{data != nullptr ? data : ""} / "clips" / "bbaf2n.mpg";
  if (data == nullptr || !std::filesystem::exists(clip)) {
    GTEST_SKIP() << "BIMODAL_TEST_DATA names no folder with clips/bbaf2n.mpg";
  }
  const auto media = examine_media(clip);
  ASSERT_TRUE(media.picture && media.sound);
  EXPECT_EQ(media.picture->width, 360U);
  EXPECT_EQ(media.picture->height, 288U);
  EXPECT_EQ(media.picture->frame_rate, Hertz{25});
  EXPECT_FALSE(media.picture->variable_rate);
  EXPECT_FALSE(media.picture->interlaced);
  EXPECT_EQ(media.picture->codec, "mpeg1video");
  EXPECT_EQ(media.sound->rate, Hertz{44'100});
  EXPECT_EQ(media.sound->channels, 2);
  EXPECT_EQ(media.length, 3s);
  FrameReader reader{clip, {.height = 0, .span = {1010ms, 1130ms}}};
  for (const std::int64_t index : {25, 26, 27, 28}) {
    const auto frame = reader.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->index, index);
    EXPECT_EQ(frame->start, index * 40ms);
    EXPECT_EQ(frame->end, (index + 1) * 40ms);
  }
  EXPECT_FALSE(reader.next());
  EXPECT_NEAR(seconds(read_sound_track(clip).duration()), 2.978, 0.001);
}

TEST_F(MediaFile, TellsWhatARecordingIs) {
  const auto file = made("a.mkv",
                         numbered_frames("30000/1001", "2") +
                             " -f lavfi -i sine=r=44100:d=1.5 -ac 2 -c:v libx264 -c:a flac");
  const auto media = examine_media(file);
  EXPECT_EQ(media.container, "matroska,webm");
  ASSERT_TRUE(media.picture && media.sound);
  EXPECT_EQ(media.picture->stored_width, 160U);
  EXPECT_EQ(media.picture->stored_height, 64U);
  EXPECT_NEAR(media.picture->frame_rate.count(), 29.97, 0.001);
  EXPECT_FALSE(media.picture->variable_rate);
  EXPECT_EQ(media.picture->codec, "h264");
  EXPECT_EQ(media.picture->pixel_format, "yuv420p");
  EXPECT_NEAR(seconds(media.picture->length), 2.002, 0.002);
  EXPECT_EQ(media.sound->channels, 2);
  EXPECT_EQ(media.sound->rate, Hertz{44'100});
  EXPECT_EQ(media.sound->codec, "flac");
  EXPECT_NEAR(seconds(media.sound->length), 1.5, 0.002);
  EXPECT_NEAR(seconds(media.length), 2.002, 0.002);
}

TEST_F(MediaFile, MeasuresWhetherFramesAreEvenlySpaced) {
  const auto uneven = made(
      "a.mkv",
      numbered_frames("25", "2") + " -vf \"setpts='(N+floor(N/3))/FR/TB'\" -vsync vfr -c:v ffv1");
  EXPECT_TRUE(examine_media(uneven).picture->variable_rate);
  const auto fields = made(
      "b.mpg", numbered_frames("25", "2") + " -c:v mpeg2video -flags +ildct+ilme -top 1 -q:v 2");
  EXPECT_TRUE(examine_media(fields).picture->interlaced);
  EXPECT_FALSE(examine_media(fields).picture->variable_rate);
}

TEST_F(MediaFile, FindsSoundWithoutPictureAndPictureWithoutSound) {
  const auto heard = examine_media(made("a.wav", "-f lavfi -i sine=d=1"));
  EXPECT_FALSE(heard.picture);
  EXPECT_EQ(heard.length, 1s);
  const auto watched = examine_media(made("b.avi", numbered_frames("25", "1") + " -c:v mjpeg"));
  EXPECT_FALSE(watched.sound);
  EXPECT_EQ(watched.length, 1s);
}

TEST_F(MediaFile, TakesACoverForNoVideo) {
  const auto cover = made("cover.png", "-f lavfi -i color=red:s=64x64 -frames:v 1");
  const auto file = made("a.mp3",
                         "-f lavfi -i sine=d=1 -i '" + cover.string() +
                             "' -map 0 -map 1 -c:a libmp3lame -c:v copy -disposition:v "
                             "attached_pic");
  EXPECT_FALSE(examine_media(file).picture);
  EXPECT_THAT(message_of([&] { FrameReader{file, {}}; }), HasSubstr("it has no picture"));
  EXPECT_THAT(refusal(cover), AllOf(HasSubstr("still picture"), HasSubstr("cover.png")));
}

TEST_F(MediaFile, SaysWhatIsWrongWithWhatIsNoRecording) {
  EXPECT_THAT(refusal(path("absent.mp4")), HasSubstr("there is no such file"));
  EXPECT_THAT(refusal(path("absent.mp4").parent_path()), HasSubstr("it is a folder"));
  EXPECT_THAT(refusal(holding("empty.mp4", "")), HasSubstr("it is empty"));
  const auto text = holding("text.mp4", "This is a text, not a recording.\nNor is this line.\n");
  EXPECT_THAT(refusal(text), AllOf(HasSubstr("text.mp4"), HasSubstr("cannot read")));
  EXPECT_THAT(refusal(holding("notes.txt", "A page of notes about the recordings.\n")),
              HasSubstr("notes.txt"));
  const auto pipe = path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(refusal(pipe), HasSubstr("no ordinary file"));
}

TEST_F(MediaFile, OpensNoOtherFileThanTheOneNamed) {
  const auto secret = made("secret.mkv", numbered_frames("25", "1") + " -c:v ffv1");
  const auto name = secret.filename().string();
  EXPECT_THAT(refusal(holding("list.mkv", "ffconcat version 1.0\nfile " + name + "\n")),
              HasSubstr("it is a list"));
  EXPECT_THAT(refusal(holding(
                  "list.m3u8",
                  "#EXTM3U\n#EXT-X-TARGETDURATION:2\n#EXTINF:1,\n" + name + "\n#EXT-X-ENDLIST\n")),
              HasSubstr("it is a list"));
  EXPECT_THAT(refusal(holding("session.sdp",
                              "v=0\no=- 0 0 IN IP4 127.0.0.1\ns=x\nc=IN IP4 127.0.0.1\nt=0 0\n"
                              "m=video 5004 RTP/AVP 96\n")),
              HasSubstr("it is a list"));
  // Names that FFmpeg would take for a protocol or a pattern are names.
  for (const std::string odd : {"concat:secret.mkv|secret.mkv", "file%03d.mkv", "http:x.mkv"}) {
    EXPECT_THAT(refusal(path(odd)), HasSubstr("there is no such file")) << odd;
    std::filesystem::copy_file(secret, path(odd));
    EXPECT_EQ(examine_media(path(odd)).picture->codec, "ffv1") << odd;
  }
}

TEST_F(MediaFile, SaysWhereATruncatedRecordingBreaksOff) {
  const auto whole = made("whole.mkv", numbered_frames("25", "4") + " -c:v ffv1 -level 3");
  const auto content = read_file(whole);
  const auto half = holding("half.mkv", content.substr(0, content.size() / 2));
  const auto media = examine_media(half);
  EXPECT_NEAR(seconds(media.length), 2.0, 0.5);
  EXPECT_THAT(message_of([&] {
                FrameReader{half, {}};
              }),
              AllOf(HasSubstr("half.mkv"), HasSubstr("it ends after "), HasSubstr("claims more")));
  FrameReader before{half, {.height = 0, .span = {0s, 1s}}};
  int frames = 0;
  while (before.next()) ++frames;
  EXPECT_EQ(frames, 25);
  EXPECT_NE(refusal(holding("stub.mkv", content.substr(0, 300))), "no error");

  const auto indexed = made("indexed.mp4",
                            numbered_frames("25", "4") +
                                " -f lavfi -i sine=d=4 -c:a pcm_s16le -f mov -c:v libx264 "
                                "-g 25 -movflags faststart");
  const auto start = read_file(indexed);
  const auto most = holding("most.mp4", start.substr(0, start.size() * 3 / 4));
  EXPECT_THAT(message_of([&] { FrameReader{most, {}}; }), HasSubstr("claims more"));
  EXPECT_THAT(message_of([&] { (void)read_sound_track(most); }), HasSubstr("claims more"));
  EXPECT_EQ(read_sound_track(most, Hertz{0}, {0s, 1s}).samples.size(), 44'100U);
}

TEST_F(MediaFile, ThrowsAtTheFrameThatIsDamagedAfterHandingOutThoseBefore) {
  const auto whole = made("whole.mkv", numbered_frames("25", "4") + " -c:v ffv1 -level 3 -g 1");
  auto content = read_file(whole);
  for (std::size_t i = content.size() / 2; i < content.size() / 2 + 200; ++i) {
    content[i] = static_cast<char>(content[i] ^ 0x55);
  }
  const auto damaged = holding("damaged.mkv", content);
  int frames = 0;
  const auto message = message_of([&] {
    FrameReader reader{damaged, {}};
    while (reader.next()) ++frames;
  });
  EXPECT_THAT(message, AllOf(HasSubstr("damaged.mkv"), HasSubstr("it is damaged")));
  EXPECT_GT(frames, 30);
  EXPECT_LT(frames, 70);
}

TEST_F(MediaFile, RefusesFramesThatClaimTooManyPixels) {
  // A frame header of JPEG that claims 60000 x 60000 pixels, in a Motion JPEG file.
  const auto file = made("a.avi", "-f lavfi -i color=red:s=64x48:r=25:d=1 -c:v mjpeg");
  auto content = read_file(file);
  std::size_t headers = 0;
  for (auto at = content.find("\xff\xc0"); at != std::string::npos;
       at = content.find("\xff\xc0", at + 9)) {
    content.replace(at + 5, 4, "\xea\x60\xea\x60");
    ++headers;
  }
  ASSERT_GE(headers, 25U);
  EXPECT_NE(refusal(holding("b.avi", content)), "no error");
}

/// Changed in a few places, cut, or with a piece repeated.
std::string mutated(std::string content, Random& random) {
  const auto any = [&] { return static_cast<std::size_t>(random.below(content.size())); };
  const auto changes = 1 + random.below(20);
  for (std::uint64_t i = 0; i < changes; ++i) {
    // Half of the changes hit the headers at the beginning.
    const auto place =
        random.below(2) == 0 ? any() : any() % std::min<std::size_t>(content.size(), 600);
    content[place] = static_cast<char>(random.below(256));
  }
  const auto kind = random.below(6);
  if (kind == 0) content.resize(1 + any());
  if (kind == 1) content.insert(any(), content.substr(any(), 1 + random.below(400)));
  if (kind == 2) content.erase(any(), 1 + random.below(400));
  return content.empty() ? "x" : content;
}

TEST_F(MediaFile, GivesAResultOrAnErrorWhateverTheFileHolds) {
  const auto picture = "-f lavfi -i testsrc=s=48x32:r=25:d=0.4 ";
  const std::string sound = "-f lavfi -i sine=r=16000:d=0.4 ";
  const std::array originals{
      made("a.mp4", picture + sound + "-c:v libx264 -bf 2 -c:a aac"),
      made("b.mkv", picture + sound + "-c:v ffv1 -c:a flac"),
      made("c.avi", picture + sound + "-c:v mjpeg -c:a pcm_s16le"),
      made("d.mpg", picture + sound + "-r 25 -c:v mpeg2video -flags +ilme+ildct -c:a mp2"),
      made("e.webm", picture + sound + "-c:v libvpx-vp9 -deadline realtime -c:a libopus -ar 48000"),
      made("f.ts", picture + sound + "-c:v libx264 -c:a aac"),
      made("g.ogg", sound + "-c:a libvorbis"),
      made("h.wav", sound)};
  std::vector<std::string> contents;
  for (const auto& file : originals) contents.push_back(read_file(file));
  // More by hand: BIMODAL_FUZZ_RUNS=5000.
  const auto* asked = std::getenv("BIMODAL_FUZZ_RUNS");
  const int runs = asked != nullptr ? std::atoi(asked) : 300;
  Random random{20};
  for (int run = 0; run < runs; ++run) {
    const auto& content = contents[static_cast<std::size_t>(run) % contents.size()];
    const auto file = holding("mutated", mutated(content, random));
    const auto message = message_of([&] {
      const auto media = examine_media(file);
      EXPECT_TRUE(media.picture || media.sound);
      if (media.picture) {
        FrameReader reader{file, {.height = 24, .span = {}}};
        for (int i = 0; i < 5; ++i) {
          const auto frame = reader.next();
          if (!frame) break;
          EXPECT_EQ(frame->image.pixels.size(), reader.width() * reader.height() * 4);
        }
      }
      if (media.sound) (void)read_sound_track(file, Hertz{0}, {0s, 100ms});
    });
    if (message != "no error") {
      EXPECT_THAT(message, HasSubstr("mutated"));
    }
  }
}

}  // namespace
}  // namespace bimodal
