#include "stimuli/video/sound_track.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/audio/sound_file.hpp"
#include "stimuli/base/random.hpp"
#include "stimuli/video/media_file.hpp"
#include "tests/stimuli/audio/signals.hpp"
#include "tests/stimuli/video/made_media.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;
using made_media::click;
using made_media::from_seconds;
using made_media::message_of;
using made_media::seconds;
using ::testing::HasSubstr;

std::ptrdiff_t loudest(const Clip& sound) {
  const auto louder = [](float a, float b) { return std::abs(a) < std::abs(b); };
  return std::ranges::max_element(sound.samples, louder) - sound.samples.begin();
}

class SoundTrackFile : public made_media::MadeMedia {
 protected:
  /// What the ffmpeg program decodes: all channels, their mean taken here.
  [[nodiscard]] std::vector<float> decoded_by_ffmpeg(const std::filesystem::path& file,
                                                     std::size_t channels) const {
    const auto raw = made("raw.f32", "-i '" + file.string() + "' -f f32le");
    std::ifstream in{raw, std::ios::binary};
    std::vector<float> mean;
    std::vector<float> all(channels);
    const auto size = static_cast<std::streamsize>(channels * sizeof(float));
    while (in.read(reinterpret_cast<char*>(all.data()), size)) {
      double sum = 0.0;
      for (const float sample : all) sum += static_cast<double>(sample);
      mean.push_back(static_cast<float>(sum / static_cast<double>(channels)));
    }
    return mean;
  }

  [[nodiscard]] std::filesystem::path recorded(const std::string& name,
                                               const std::string& options) {
    return made(name, "-f lavfi -i \"anoisesrc=d=1.3:r=48000:seed=5:a=0.4\" " + options);
  }
};

struct Format {
  std::string name;
  std::string file;
  std::string options;
  std::size_t channels = 1;
};

std::ostream& operator<<(std::ostream& out, const Format& format) {
  return out << format.name;
}

class EveryFormat : public SoundTrackFile, public ::testing::WithParamInterface<Format> {};

TEST_P(EveryFormat, GivesTheMeanOfWhatTheFfmpegProgramDecodes) {
  const auto& format = GetParam();
  const auto file = recorded(format.file, format.options);
  const auto theirs = decoded_by_ffmpeg(file, format.channels);
  const auto ours = read_sound_track(file);
  ASSERT_GT(ours.samples.size(), 1000U);
  ASSERT_EQ(ours.samples.size(), theirs.size());
  EXPECT_LT(testing_signals::largest_difference(ours.samples, theirs), 1e-6);
  const auto media = examine_media(file);
  ASSERT_TRUE(media.sound);
  EXPECT_EQ(media.sound->channels, static_cast<int>(format.channels));
  EXPECT_EQ(media.sound->rate, ours.rate);
  EXPECT_NEAR(seconds(media.sound->length), seconds(ours.duration()), 0.002);
}

INSTANTIATE_TEST_SUITE_P(
    Of,
    EveryFormat,
    ::testing::Values(Format{"Pcm16", "a.wav", "-c:a pcm_s16le"},
                      Format{"Pcm8At8kHz", "b.wav", "-ar 8000 -c:a pcm_u8"},
                      Format{"Pcm24", "c.wav", "-c:a pcm_s24le -ac 2", 2},
                      Format{"Pcm32", "d.wav", "-c:a pcm_s32le"},
                      Format{"FloatAt96kHz", "e.wav", "-ar 96000 -c:a pcm_f32le"},
                      Format{"DoubleInMov", "f.mov", "-c:a pcm_f64le"},
                      Format{"SixChannels", "g.wav", "-ac 6 -c:a pcm_s16le", 6},
                      Format{"Flac", "h.flac", "-ac 2 -c:a flac", 2},
                      Format{"FlacInMkv", "i.mkv", "-c:a flac"},
                      Format{"Vorbis", "j.ogg", "-c:a libvorbis -ac 2", 2},
                      Format{"OpusInOgg", "k.opus", "-c:a libopus"},
                      Format{"AacInMp4", "l.m4a", "-c:a aac -ac 2", 2},
                      Format{"Mp3", "m.mp3", "-c:a libmp3lame"},
                      Format{"Alaw", "n.wav", "-ar 8000 -c:a pcm_alaw"}),
    [](const auto& each) { return each.param.name; });

struct Container {
  std::string name;
  std::string file;
  std::string options;
  double tolerance = 0.0;  ///< seconds
};

std::ostream& operator<<(std::ostream& out, const Container& container) {
  return out << container.name;
}

class EveryContainer : public SoundTrackFile, public ::testing::WithParamInterface<Container> {};

TEST_P(EveryContainer, PutsAClickWhereThePictureFlashes) {
  const auto& container = GetParam();
  // White at 1 s of the picture, a click at 1 s of the sound.
  const auto file = made(container.file,
                         "-f lavfi -i \"color=black:s=64x48:r=25:d=2,"
                         "geq=lum='if(eq(N,25),235,16)':cb=128:cr=128\" " +
                             click("48000", "2") + " " + container.options);
  const auto media = examine_media(file);
  ASSERT_TRUE(media.picture && media.sound);
  const auto zero = std::min(media.picture->start, media.sound->start);
  const auto sound = read_sound_track(file);
  const double heard = static_cast<double>(loudest(sound)) / 48'000.0;
  const double seen = 1.0 + seconds(media.picture->start - zero);
  EXPECT_NEAR(heard, seen, container.tolerance) << "picture from " << seconds(media.picture->start)
                                                << ", sound from " << seconds(media.sound->start);
  const auto span = MediaSpan{from_seconds(seen - 0.1), from_seconds(seen + 0.1)};
  const auto cut = read_sound_track(file, Hertz{0}, span);
  EXPECT_EQ(cut.samples.size(), 9'600U);
  EXPECT_NEAR(static_cast<double>(loudest(cut)) / 48'000.0, 0.1, container.tolerance + 2.1e-5);
}

constexpr double kOneSample = 1.01 / 48'000.0;
constexpr double kMillisecond = 0.001;  // the clock of Matroska

INSTANTIATE_TEST_SUITE_P(
    Of,
    EveryContainer,
    ::testing::Values(
        Container{"PcmInMov", "a.mov", "-c:v libx264 -bf 2 -c:a pcm_s16le", kOneSample},
        Container{"PcmInAvi", "b.avi", "-c:v mjpeg -c:a pcm_s16le", kOneSample},
        Container{"FlacInMp4", "c.mp4", "-c:v libx264 -c:a flac -strict -2", kOneSample},
        Container{"FlacInMkv", "d.mkv", "-c:v libx264 -bf 2 -c:a flac", kMillisecond},
        Container{"AacInMp4", "e.mp4", "-c:v libx264 -bf 2 -c:a aac -b:a 192k", 0.002},
        Container{"AacInMkv", "f.mkv", "-c:v libx264 -bf 2 -c:a aac -b:a 192k", 0.002},
        // FFmpeg 5.1 writes the picture 7 ms late: it allows for the codec's delay twice.
        Container{"OpusInWebm", "g.webm", "-c:v libvpx-vp9 -c:a libopus -b:a 128k", 0.009},
        Container{"OpusInMp4", "h.mp4", "-c:v libx264 -c:a libopus -b:a 128k -strict -2", 0.002},
        Container{"Mp2InMpeg", "i.mpg", "-c:v mpeg1video -c:a mp2 -b:a 256k", 0.002},
        Container{"Mp2InMpegTs", "j.ts", "-c:v mpeg2video -c:a mp2 -b:a 256k", 0.002}),
    [](const auto& each) { return each.param.name; });

TEST_F(SoundTrackFile, IsTheSameInEveryStretch) {
  for (const auto& [name, options] :
       {std::pair{"a.wav", "-c:a pcm_s16le"}, {"b.m4a", "-c:a aac"}, {"c.opus", "-c:a libopus"}}) {
    const auto file = recorded(name, options);
    const auto whole = read_sound_track(file);
    Random random{4};
    for (int i = 0; i < 10; ++i) {
      const auto start = from_seconds(random.uniform() * 0.6);
      const auto end = start + from_seconds(0.01 + random.uniform() * 0.5);
      const auto part = read_sound_track(file, Hertz{0}, {start, end});
      const auto first = nearest_sample(start, whole.rate).count();
      const auto last = nearest_sample(end, whole.rate).count();
      ASSERT_EQ(part.samples.size(), static_cast<std::size_t>(last - first)) << name;
      ASSERT_TRUE(std::ranges::equal(
          part.samples,
          std::span{whole.samples}.subspan(static_cast<std::size_t>(first), part.samples.size())))
          << name << " from " << seconds(start);
    }
  }
}

TEST_F(SoundTrackFile, EqualsTheWavFileReaderAndSox) {
  const auto file = recorded("a.wav", "-ac 2 -c:a pcm_s24le");
  const auto ours = read_sound_track(file);
  EXPECT_EQ(ours.samples, read_sound(file, Channels::MixDown).samples);
  if (!made_media::have("sox")) GTEST_SKIP() << "sox is absent";
  const auto mixed = path("mixed.wav");
  (void)made_media::printed("sox -V1 -D '" + file.string() + "' -e float -b 32 '" + mixed.string() +
                            "' remix -");
  EXPECT_LT(testing_signals::largest_difference(ours.samples, read_sound(mixed).samples), 1e-6);
}

TEST_F(SoundTrackFile, ChangesTheRateWhenAsked) {
  const auto file = made("a.wav", "-f lavfi -i \"sine=f=440:r=44100:d=1\" -c:a pcm_s16le");
  const auto sound = read_sound_track(file, Hertz{48'000});
  EXPECT_EQ(sound.rate, Hertz{48'000});
  EXPECT_EQ(sound.samples.size(), 48'000U);
  const auto own = read_sound_track(file);
  EXPECT_NEAR(testing_signals::rms(sound.samples), testing_signals::rms(own.samples), 1e-3);
}

TEST_F(SoundTrackFile, IsSilentBeforeItBeginsAndAfterItEnds) {
  // The picture lasts from 0 to 3 s, the sound from 1 to 2 s.
  const auto file = made("a.mkv",
                         "-f lavfi -i color=blue:s=64x48:r=25:d=3 -itsoffset 1 "
                         "-f lavfi -i \"aevalsrc=0.5:s=48000:d=1\" -c:v ffv1 -c:a pcm_s16le");
  const auto whole = read_sound_track(file);
  EXPECT_EQ(whole.samples.size(), 96'000U);
  EXPECT_EQ(std::ranges::find_if(whole.samples, [](float it) { return it != 0.0F; }) -
                whole.samples.begin(),
            48'000);
  const auto around = read_sound_track(file, Hertz{0}, {1900ms, 2500ms});
  ASSERT_EQ(around.samples.size(), 28'800U);
  EXPECT_NEAR(around.samples[4'799], 0.5, 1e-4);
  EXPECT_EQ(around.samples[4'800], 0.0F);
  EXPECT_EQ(around.samples.back(), 0.0F);
  EXPECT_THAT(message_of([&] { (void)read_sound_track(file, Hertz{0}, {2500ms}); }),
              HasSubstr("it ends before 2.500 s"));
}

TEST_F(SoundTrackFile, FillsGapsWithSilence) {
  // Half a second is missing from the middle, and the time stamps say so.
  const auto file = made("a.mkv",
                         "-f lavfi -i \"aevalsrc=0.5:s=48000:d=2,"
                         "aselect='not(between(t,0.5,1))'\" -c:a pcm_s16le");
  const auto sound = read_sound_track(file);
  EXPECT_NEAR(static_cast<double>(sound.samples.size()), 96'000.0, 1'100.0);
  EXPECT_NEAR(sound.samples[12'000], 0.5, 1e-4);
  EXPECT_EQ(sound.samples[36'000], 0.0F);
  EXPECT_NEAR(sound.samples[72'000], 0.5, 1e-4);
}

TEST_F(SoundTrackFile, RefusesWhatIsNotThere) {
  const auto mute = made("a.mkv", "-f lavfi -i color=blue:s=64x48:r=25:d=1 -c:v ffv1");
  EXPECT_THAT(message_of([&] { (void)read_sound_track(mute); }), HasSubstr("it has no sound"));
  const auto file = recorded("b.wav", "-c:a pcm_s16le");
  for (const auto& span : {MediaSpan{-1ms, 1s},
                           MediaSpan{1s, 1s},
                           MediaSpan{1s, 500ms},
                           MediaSpan{1400ms, 2s},
                           MediaSpan{0s, 2s}}) {
    EXPECT_THAT(message_of([&] { (void)read_sound_track(file, Hertz{0}, span); }),
                HasSubstr("it lasts 1.300 s, the stretch is to go from"));
  }
  EXPECT_EQ(read_sound_track(file, Hertz{0}, {0s, 1310ms}).samples.size(), 62'880U);
}

TEST_F(SoundTrackFile, RefusesSamplesThatAreNoNumbers) {
  const auto file = path("a.wav");
  write_wav(file, {Hertz{48'000}, std::vector<float>(2'000, 0.25F)});
  {
    std::fstream patch{file, std::ios::binary | std::ios::in | std::ios::out};
    patch.seekp(-4, std::ios::end);
    const float bad = std::numeric_limits<float>::quiet_NaN();
    patch.write(reinterpret_cast<const char*>(&bad), sizeof bad);
  }
  EXPECT_THAT(message_of([&] { (void)read_sound_track(file); }),
              HasSubstr("sample 1999 is not a finite number"));
}

}  // namespace
}  // namespace bimodal
