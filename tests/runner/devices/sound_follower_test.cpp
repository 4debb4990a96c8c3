#include "runner/devices/sound_follower.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/runner/realtime/count_allocations.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

constexpr double kRate = 48'000.0;

/// A device that asks for buffers of one size; its samples leave at the rate that it states.
class SoundFollowerTest : public testing::Test {
 protected:
  /// The instant at which a sample leaves, by the true clock.
  [[nodiscard]] Instant leaves(std::int64_t sample) const {
    return Instant{10s + Duration{std::llround(static_cast<double>(sample) / kRate * 1e9)} + late_};
  }

  void ask_up_to(std::int64_t sample, std::int64_t frames = 256) {
    for (; next_ < sample; next_ += frames) {
      follower_.note_buffer({next_, leaves(next_)}, frames);
      follower_.follow();
    }
  }

  [[nodiscard]] double off_ms(std::int64_t sample) const {
    return std::abs(
               static_cast<double>((*follower_.playback().onset - true_onset(sample)).count())) *
           1e-6;
  }

  /// As it was heard: by the clock before any jump.
  [[nodiscard]] static Instant true_onset(std::int64_t sample) {
    return Instant{10s + Duration{std::llround(static_cast<double>(sample) / kRate * 1e9)}};
  }

  SoundFollower follower_{Hertz{kRate}};
  std::int64_t next_ = 0;
  Duration late_{};  ///< from now on: the device left samples out
};

constexpr std::int64_t kStart = 96'000;
constexpr std::int64_t kLength = 48'000;

TEST_F(SoundFollowerTest, ToldOfNothingThereIsNothingToKnow) {
  EXPECT_TRUE(follower_.playback().finished);
  EXPECT_TRUE(follower_.playback().known);
  EXPECT_FALSE(follower_.playback().onset);
}

TEST_F(SoundFollowerTest, TellsWhenASoundWasHeard) {
  ask_up_to(kStart);
  follower_.expect(0, kLength);
  EXPECT_FALSE(follower_.playback().known);
  follower_.note_start(kStart);
  ask_up_to(kStart + kLength);
  EXPECT_LT(off_ms(kStart), 1e-3);
  EXPECT_FALSE(follower_.playback().finished);
  follower_.note_end(2);
  ask_up_to(kStart + kLength + 20 * 256);
  EXPECT_TRUE(follower_.playback().finished);
  EXPECT_TRUE(follower_.playback().known);
  EXPECT_FALSE(follower_.playback().jumped);
  EXPECT_EQ(follower_.playback().underflows, 2);
}

TEST_F(SoundFollowerTest, CountsTheSilentHeadToTheSound) {
  constexpr std::int64_t kHead = 4'800;
  ask_up_to(kStart);
  follower_.expect(kHead, kLength);
  follower_.note_start(kStart + kHead);
  ask_up_to(kStart + 2 * kHead);
  EXPECT_EQ(follower_.playback().start_sample, kStart);
  EXPECT_LT(off_ms(kStart), 1e-3);
}

TEST_F(SoundFollowerTest, AJumpInTheMiddleFlagsTheSoundAndLeavesItsOnset) {
  ask_up_to(kStart);
  follower_.expect(0, kLength);
  follower_.note_start(kStart);
  ask_up_to(kStart + kLength / 2);
  late_ = 20ms;
  ask_up_to(kStart + kLength);
  EXPECT_TRUE(follower_.playback().jumped);
  EXPECT_LT(off_ms(kStart), 1e-3);
}

TEST_F(SoundFollowerTest, AJumpRightAfterTheOnsetDoesNotMoveIt) {
  ask_up_to(kStart);
  follower_.expect(0, kLength);
  follower_.note_start(kStart);
  ask_up_to(kStart + 512);
  late_ = 20ms;
  ask_up_to(kStart + kLength);
  EXPECT_TRUE(follower_.playback().jumped);
  EXPECT_LT(off_ms(kStart), 1e-3);
}

TEST_F(SoundFollowerTest, AJumpWhileTheSoundIsOnItsWayMovesItsOnset) {
  ask_up_to(kStart - 48'000);
  follower_.expect(0, kLength);
  late_ = 20ms;
  ask_up_to(kStart);
  follower_.note_start(kStart);
  ask_up_to(kStart + kLength);
  EXPECT_FALSE(follower_.playback().jumped);
  EXPECT_LT(std::abs(off_ms(kStart) - 20.0), 1e-3);
}

/// The readings that confirm the jump come when the sound has begun: its onset is that of the clock
/// after the jump, however large the buffers.
class SoundFollowerBuffers : public SoundFollowerTest,
                             public testing::WithParamInterface<std::int64_t> {};

TEST_P(SoundFollowerBuffers, AJumpJustBeforeTheOnsetIsKnownInTheEnd) {
  const auto frames = GetParam();
  const std::int64_t start = 400 * frames;
  ask_up_to(start - 2 * frames, frames);
  follower_.expect(0, 40 * frames);
  late_ = 20ms;
  ask_up_to(start, frames);
  follower_.note_start(start);
  ask_up_to(start + 40 * frames, frames);
  EXPECT_LT(std::abs(off_ms(start) - 20.0), 1e-3);
  EXPECT_FALSE(follower_.playback().jumped) << "nothing of the sound was lost";
}

TEST_P(SoundFollowerBuffers, AJumpInTheLastBuffersIsKnownBeforeTheSoundIs) {
  const auto frames = GetParam();
  const std::int64_t start = 400 * frames;
  const std::int64_t length = 40 * frames;
  ask_up_to(start, frames);
  follower_.expect(0, length);
  follower_.note_start(start);
  ask_up_to(start + length - 2 * frames, frames);
  late_ = 20ms;
  ask_up_to(start + length, frames);
  follower_.note_end(0);
  for (int buffers = 0; !follower_.playback().known && buffers < 100; ++buffers) {
    ask_up_to(next_ + frames, frames);
  }
  EXPECT_TRUE(follower_.playback().known);
  EXPECT_TRUE(follower_.playback().jumped);
}

INSTANTIATE_TEST_SUITE_P(OfEverySize,
                         SoundFollowerBuffers,
                         testing::Values(64, 128, 256, 480, 1'024, 4'096));

TEST_F(SoundFollowerTest, OfALostDeviceNothingMoreWillBeKnown) {
  ask_up_to(kStart);
  follower_.expect(0, kLength);
  follower_.note_loss();
  follower_.follow();
  EXPECT_TRUE(follower_.playback().lost);
  EXPECT_TRUE(follower_.playback().finished);
  EXPECT_TRUE(follower_.playback().known);
}

TEST_F(SoundFollowerTest, AllocatesNothing) {
  ask_up_to(kStart);
  follower_.expect(0, kLength);
  follower_.note_start(kStart);
  const auto before = allocations_of_this_thread();
  ask_up_to(kStart + 4 * kLength);
  EXPECT_EQ(allocations_of_this_thread(), before);
}

}  // namespace
}  // namespace bimodal::runner
