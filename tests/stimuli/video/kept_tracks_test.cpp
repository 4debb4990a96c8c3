#include "stimuli/video/kept_tracks.hpp"

#include "stimuli/base/random.hpp"
#include "tests/stimuli/video/made_media.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;
using made_media::message_of;

class KeptTracksOfFile : public made_media::MadeMedia {
 protected:
  [[nodiscard]] std::filesystem::path noise(const std::string& name, const std::string& options) {
    return made(name, "-f lavfi -i \"anoisesrc=d=3:r=44100:seed=5:a=0.4\" " + options);
  }
};

TEST_F(KeptTracksOfFile, ReadTheVerySamplesOfTheFile) {
  KeptTracks tracks;
  Random random{3};
  // Lossy with priming; one that begins later than the picture beside it.
  const auto later = made("later.mkv",
                          "-f lavfi -i testsrc2=size=64x48:rate=25:d=3 -itsoffset 0.5 -f lavfi -i "
                          "\"anoisesrc=d=2:r=48000:seed=6:a=0.4\" -c:v ffv1 -c:a pcm_s16le");
  for (const auto& file : {noise("a.m4a", "-c:a aac"), noise("b.wav", ""), later}) {
    for (int i = 0; i < 40; ++i) {
      const auto start = std::chrono::microseconds{random.below(2'600'000)};
      const auto end = start + std::chrono::microseconds{1 + random.below(600'000)};
      const Hertz rate{i % 2 == 0 ? 0.0 : 48'000.0};
      const auto expected = message_of([&] {
        const auto direct = read_sound_track(file, rate, {start, end});
        const auto kept = tracks.read(file, rate, {start, end});
        EXPECT_EQ(kept.rate, direct.rate);
        EXPECT_EQ(kept.samples, direct.samples) << file << ' ' << start.count();
      });
      // Either both or none: the first to throw is the direct one.
      if (expected != "no error") {
        EXPECT_EQ(message_of([&] {
                    static_cast<void>(tracks.read(file, rate, {start, end}));
                  }),
                  expected);
      }
    }
  }
  EXPECT_EQ(tracks.decoded(), 3U);
}

TEST_F(KeptTracksOfFile, KeepWhatFitsTheLastUsedFirst) {
  KeptTracks tracks{2 * 3 * 44'100 + 1};
  const auto a = noise("a.wav", "");
  const auto b = noise("b.wav", "");
  const auto c = noise("c.wav", "");
  const auto read = [&](const std::filesystem::path& file) {
    static_cast<void>(tracks.read(file, Hertz{0}, {1s, 2s}));
    return tracks.decoded();
  };
  EXPECT_EQ(read(a), 1U);
  EXPECT_EQ(read(b), 2U);
  EXPECT_EQ(read(a), 2U);
  EXPECT_EQ(read(c), 3U);
  EXPECT_EQ(read(a), 3U) << "b was used longest ago";
  EXPECT_EQ(read(b), 4U);
  KeptTracks none{1'000};
  EXPECT_EQ(none.read(a, Hertz{0}, {1s, 2s}).samples.size(), 44'100U);
  EXPECT_EQ(none.decoded(), 0U);
}

}  // namespace
}  // namespace bimodal
