#include "stimuli/corpus/speech_chunks.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;

double decibels_as_factor(double level) {
  return std::pow(10.0, level / 20.0);
}

/// Noise of the room, and in some stretches a voice-like tone complex above it.
Clip room_with(const std::vector<SpeechInterval>& spoken,
               Duration length,
               double rate,
               double room_db,
               double voice_db,
               Random& random) {
  const auto seconds = std::chrono::duration<double>{length}.count();
  Clip clip{Hertz{rate}, std::vector<float>(static_cast<std::size_t>(seconds * rate))};
  for (std::size_t n = 0; n < clip.samples.size(); ++n) {
    const double time = static_cast<double>(n) / rate;
    double sample = decibels_as_factor(room_db) * random.normal();
    for (const auto& stretch : spoken) {
      const Duration at{std::llround(time * 1e9)};
      if (at < stretch.start || at >= stretch.end) continue;
      for (const double harmonic : {1.0, 3.0, 7.0}) {
        sample += decibels_as_factor(voice_db) *
                  std::sin(2.0 * std::numbers::pi * 150.0 * harmonic * time);
      }
    }
    clip.samples[n] = static_cast<float>(sample);
  }
  return clip;
}

TEST(SpeechChunks, AreWhereTheSoundIsAtAnyLevelAndRate) {
  Random random{1};
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<SpeechInterval> spoken;
    Duration at = 300ms;
    const auto count = 1 + random.below(8);
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto length = std::chrono::milliseconds{120 + random.below(700)};
      spoken.push_back({at, at + length});
      at += length + std::chrono::milliseconds{300 + random.below(2000)};
    }
    const double rate = std::vector{16'000.0, 22'050.0, 48'000.0}.at(random.below(3));
    const double room = -75.0 + 15.0 * random.uniform();
    const auto clip = room_with(spoken, at, rate, room, room + 35.0, random);
    const auto found = find_speech(clip);
    ASSERT_EQ(found.size(), spoken.size()) << "trial " << trial;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_LE(std::chrono::abs(found[i].start - spoken[i].start), 25ms) << "trial " << trial;
      EXPECT_LE(std::chrono::abs(found[i].end - spoken[i].end), 25ms) << "trial " << trial;
    }
  }
}

TEST(SpeechChunks, FollowARoomThatBecomesLouder) {
  Random random{2};
  const std::vector<SpeechInterval> spoken{{5s, 5500ms}, {35s, 35500ms}};
  auto clip = room_with(spoken, 40s, 16'000, -80, -35, random);
  for (std::size_t n = 20 * 16'000; n < clip.samples.size(); ++n) {
    clip.samples[n] += static_cast<float>(0.003 * random.normal());
  }
  const auto found = find_speech(clip);
  ASSERT_GE(found.size(), 2U);
  EXPECT_EQ(std::ranges::count_if(
                found, [](const auto& chunk) { return chunk.start > 21s && chunk.end < 34s; }),
            0);
  EXPECT_NEAR(std::chrono::duration<double>{found.back().start}.count(), 35.0, 0.03);
}

TEST(SpeechChunks, BridgeTheClosureOfAStopButNotAPause) {
  Random random{3};
  const auto chunks_with_gap = [&](Duration gap) {
    const std::vector<SpeechInterval> spoken{{1s, 1300ms}, {1300ms + gap, 1600ms + gap}};
    return find_speech(room_with(spoken, 3s, 16'000, -70, -30, random)).size();
  };
  EXPECT_EQ(chunks_with_gap(120ms), 1U);
  EXPECT_EQ(chunks_with_gap(300ms), 2U);
}

TEST(SpeechChunks, LeaveOutClicksAndRumble) {
  Random random{4};
  auto clip = room_with({}, 4s, 16'000, -75, 0, random);
  clip.samples[30'000] = 0.5F;
  for (std::size_t n = 0; n < clip.samples.size(); ++n) {
    // A truck at 15 Hz, 50 dB above the room.
    if (n > 40'000)
      clip.samples[n] += static_cast<float>(0.02 * std::sin(0.0059 * static_cast<double>(n)));
  }
  EXPECT_THAT(find_speech(clip), testing::IsEmpty());
}

TEST(SpeechChunks, AreNoneInSilenceAndInNothing) {
  EXPECT_THAT(find_speech({}), testing::IsEmpty());
  EXPECT_THAT(find_speech({Hertz{8'000}, std::vector<float>(80'000)}), testing::IsEmpty());
}

TEST(SpeechChunks, LevelsOfFramesAreThoseOfASine) {
  Clip clip{Hertz{44'100}, std::vector<float>(44'100)};
  for (std::size_t n = 0; n < clip.samples.size(); ++n) {
    clip.samples[n] = 0.1F * static_cast<float>(std::sin(2 * std::numbers::pi * 1000.0 / 44'100.0 *
                                                         static_cast<double>(n)));
  }
  const auto levels = frame_levels(clip, {}, 10ms);
  ASSERT_EQ(levels.size(), 100U);
  // 0.1 sqrt(1/2) is -23.01 dB; ten periods a frame.
  for (std::size_t i = 10; i < levels.size(); ++i) EXPECT_NEAR(levels[i], -23.01, 0.1);
}

}  // namespace
}  // namespace bimodal
