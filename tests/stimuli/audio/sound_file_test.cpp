#include "stimuli/audio/sound_file.hpp"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"
#include "tests/stimuli/audio/signals.hpp"

namespace bimodal {
namespace {

using ::testing::HasSubstr;

class SoundFile : public ::testing::Test {
 public:
  SoundFile()
      : folder_{std::filesystem::temp_directory_path() /
                ("bimodal_sound_file_" + std::to_string(::getpid()))} {
    std::filesystem::create_directories(folder_);
  }

  SoundFile(const SoundFile&) = delete;
  SoundFile& operator=(const SoundFile&) = delete;
  SoundFile(SoundFile&&) = delete;
  SoundFile& operator=(SoundFile&&) = delete;

  ~SoundFile() override { std::filesystem::remove_all(folder_); }

 protected:
  [[nodiscard]] std::filesystem::path path(const char* name) const { return folder_ / name; }

  [[nodiscard]] std::filesystem::path holding(const char* name, const std::string& content) const {
    std::ofstream{path(name), std::ios::binary} << content;
    return path(name);
  }

 private:
  std::filesystem::path folder_;
};

std::string little_endian(std::uint32_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) {
    text += static_cast<char>(value & 0xFFU);
    value >>= 8U;
  }
  return text;
}

/// A WAV file of 16-bit samples, byte by byte from its definition.
std::string wav16(std::uint32_t rate, std::uint32_t channels, const std::vector<int>& samples) {
  const auto bytes = static_cast<std::uint32_t>(samples.size() * 2);
  std::string content = "RIFF" + little_endian(36 + bytes, 4) + "WAVEfmt " + little_endian(16, 4) +
                        little_endian(1, 2) + little_endian(channels, 2) + little_endian(rate, 4) +
                        little_endian(rate * channels * 2, 4) + little_endian(channels * 2, 2) +
                        little_endian(16, 2) + "data" + little_endian(bytes, 4);
  for (const int sample : samples) content += little_endian(static_cast<std::uint32_t>(sample), 2);
  return content;
}

std::string message_of(const std::function<void()>& deed) {
  try {
    deed();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(SoundFile, ReadsA16BitWavAsFullScaleUnits) {
  const auto sound = read_sound(holding("a.wav", wav16(16'000, 1, {0, 16'384, -32'768, 32'767})));
  EXPECT_EQ(sound.rate, Hertz{16'000});
  EXPECT_EQ(sound.samples, (std::vector<float>{0.0F, 0.5F, -1.0F, 32'767.0F / 32'768.0F}));
}

TEST_F(SoundFile, WritesFloatsThatAreReadBackUnchanged) {
  Clip sound{Hertz{44'100}, testing_signals::repeatable(20'001)};
  sound.samples[7] = 1.75F;  // beyond full scale
  write_wav(path("b.wav"), sound);
  const auto again = read_sound(path("b.wav"));
  EXPECT_EQ(again.rate, sound.rate);
  EXPECT_EQ(again.samples, sound.samples);
}

TEST_F(SoundFile, Writes24BitsToHalfAStep) {
  const Clip sound{Hertz{48'000}, testing_signals::repeatable(2000)};
  write_wav(path("c.wav"), sound, SampleFormat::Pcm24);
  const auto again = read_sound(path("c.wav"));
  EXPECT_LT(testing_signals::largest_difference(again.samples, sound.samples), 0x1p-22);
}

TEST_F(SoundFile, WritesTheSameBytesForTheSameSoundAndLeavesNoDraft) {
  const Clip sound{Hertz{48'000}, testing_signals::repeatable(500)};
  write_wav(path("d.wav"), sound);
  write_wav(path("e.wav"), sound);
  EXPECT_EQ(sha256_of_file(path("d.wav")), sha256_of_file(path("e.wav")));
  EXPECT_THAT(read_file(path("d.wav")), testing::Not(HasSubstr("PEAK")));
  write_wav(path("d.wav"), sound);  // replaces
  const std::filesystem::directory_iterator files{path("d.wav").parent_path()};
  EXPECT_EQ(std::distance(begin(files), end(files)), 2);
}

TEST_F(SoundFile, RefusesSeveralChannelsUnlessAskedToMixThemDown) {
  const auto file = holding("f.wav", wav16(16'000, 2, {16'384, 0, -8'192, 8'192}));
  EXPECT_EQ(message_of([&] { (void)read_sound(file); }),
            "cannot read '" + file.string() +
                "': it has 2 channels; give a recording of one, e.g. by 'sox IN OUT remix 1'");
  EXPECT_EQ(read_sound(file, Channels::MixDown).samples, (std::vector<float>{0.25F, 0.0F}));
}

TEST_F(SoundFile, RefusesWhatIsNoSound) {
  EXPECT_THAT(message_of([&] { (void)read_sound(path("absent.wav")); }), HasSubstr("absent.wav"));
  EXPECT_THAT(message_of([&] { (void)read_sound(path("absent.wav").parent_path()); }),
              HasSubstr("it is a folder"));
  EXPECT_NE(message_of([&] { (void)read_sound(holding("g.wav", "not a sound")); }), "no error");
  EXPECT_NE(message_of([&] { (void)read_sound(holding("h.wav", "")); }), "no error");
  EXPECT_THAT(message_of([&] { (void)read_sound(holding("i.wav", wav16(16'000, 1, {}))); }),
              HasSubstr("holds no samples"));
  // 8000 samples per second, mu-law, one channel, in Sun's format
  EXPECT_THAT(
      message_of([&] {
        (void)read_sound(holding("j.au",
                                 std::string{".snd\0\0\0\x18\0\0\0\x04\0\0\0\x01\0\0\x1f\x40"
                                             "\0\0\0\x01\x55\x55\x55\x55",
                                             28}));
      }),
      HasSubstr("it is neither WAV nor FLAC"));
}

TEST_F(SoundFile, RefusesRatesThatNoRecordingHas) {
  EXPECT_THAT(message_of([&] {
                (void)read_sound(holding("k.wav", wav16(100, 1, {1, 2})));
              }),
              HasSubstr("it has 100 samples per second"));
  EXPECT_THAT(message_of([&] { (void)read_sound(holding("l.wav", wav16(2'000'000, 1, {1}))); }),
              HasSubstr("it has 2000000 samples per second"));
}

TEST_F(SoundFile, NamesTheSampleThatIsNoNumber) {
  Clip sound{Hertz{48'000}, {0.0F, 0.25F, 0.5F}};
  write_wav(path("m.wav"), sound);
  auto content = read_file(path("m.wav"));
  content.replace(content.size() - 4, 4, little_endian(0x7fc00000U, 4));
  EXPECT_THAT(message_of([&] { (void)read_sound(holding("n.wav", content)); }),
              HasSubstr("sample 2 is not a finite number"));
  sound.samples[1] = std::nanf("");
  EXPECT_THAT(message_of([&] { write_wav(path("o.wav"), sound); }),
              HasSubstr("sample 1 is not a finite number"));
  EXPECT_FALSE(std::filesystem::exists(path("o.wav")));
}

TEST_F(SoundFile, SurvivesHeadersThatLie) {
  const auto honest = wav16(16'000, 1, std::vector<int>(300, 5));
  Random random{77};
  for (int i = 0; i < 500; ++i) {
    auto content = honest;
    for (int k = 0; k < 3; ++k) content.at(random.below(44)) = static_cast<char>(random.below(256));
    if (random.below(2) == 0) content.resize(random.below(content.size()));
    try {
      const auto sound = read_sound(holding("p.wav", content));
      EXPECT_LE(sound.samples.size(), content.size());
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("p.wav"));
    }
  }
}

TEST_F(SoundFile, RefusesToClipAndToWriteNowhere) {
  const Clip loud{Hertz{48'000}, {0.0F, 2.0F}};
  EXPECT_THAT(message_of([&] { write_wav(path("q.wav"), loud, SampleFormat::Pcm24); }),
              HasSubstr("6.0 dB too loud"));
  EXPECT_THAT(message_of([&] { write_wav(path("no/such/r.wav"), loud); }), HasSubstr("r.wav"));
  EXPECT_THAT(message_of([&] {
                write_wav(path("s.wav"), Clip{Hertz{44'100.5}, {0.0F}});
              }),
              HasSubstr("44100.5 samples per second"));
}

}  // namespace
}  // namespace bimodal
