#include "runner/devices/simulated/simulated_audio.hpp"

#include <gtest/gtest.h>

#include "runner/devices/silent/silent_audio.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class ManualClock final : public Clock {
 public:
  [[nodiscard]] Instant now() const override { return now_; }

  void set(Duration since_zero) { now_ = Instant{since_zero}; }

 private:
  Instant now_;
};

Sound sound_of(std::size_t samples) {
  return {Hertz{48'000}, std::make_shared<const std::vector<float>>(samples, 0.5F)};
}

TEST(SimulatedAudio, StartsExactlyWhenScheduledAndEndsAfterTheSound) {
  ManualClock clock;
  SimulatedAudio audio{clock};
  EXPECT_TRUE(audio.playback().finished);
  const Instant onset{milliseconds{1234} + Duration{567}};
  audio.schedule(sound_of(24'000), onset);
  EXPECT_FALSE(audio.playback().onset.has_value());
  EXPECT_FALSE(audio.playback().finished);
  clock.set(onset.time_since_epoch() - Duration{1});
  EXPECT_FALSE(audio.playback().onset.has_value());
  clock.set(onset.time_since_epoch());
  EXPECT_EQ(audio.playback().onset, onset);
  EXPECT_EQ(audio.playback().start_sample, 59'232);
  EXPECT_EQ(audio.playback().source, "predicted");
  clock.set(onset.time_since_epoch() + milliseconds{500} - Duration{1});
  EXPECT_FALSE(audio.playback().finished);
  clock.set(onset.time_since_epoch() + milliseconds{500});
  EXPECT_TRUE(audio.playback().finished);
  EXPECT_EQ(audio.playback().onset, onset);
  EXPECT_EQ(audio.playback().underflows, 0);
}

TEST(SimulatedAudio, StartsAtOnceWhatIsScheduledInThePast) {
  ManualClock clock;
  clock.set(seconds{2});
  SimulatedAudio audio{clock};
  audio.schedule(sound_of(480), Instant{seconds{1}});
  EXPECT_EQ(audio.playback().onset, Instant{seconds{2}});
}

TEST(SimulatedAudio, EndsAStoppedSoundWithinItsFade) {
  ManualClock clock;
  SimulatedAudio audio{clock};
  audio.schedule(sound_of(48'000), Instant{});
  clock.set(milliseconds{100});
  audio.stop();
  clock.set(milliseconds{105});
  EXPECT_TRUE(audio.playback().finished);
  audio.schedule(sound_of(48'000), Instant{seconds{1}});
  audio.stop();
  EXPECT_TRUE(audio.playback().finished);
  EXPECT_FALSE(audio.playback().onset.has_value());
}

TEST(SimulatedAudio, RefusesASoundOfAnotherRate) {
  ManualClock clock;
  SimulatedAudio audio{clock, Hertz{44'100}};
  EXPECT_THROW(audio.schedule(sound_of(10), Instant{}), Error);
  EXPECT_THROW(audio.schedule(Sound{Hertz{44'100}, nullptr}, Instant{}), Error);
}

TEST(SilentAudio, NeverClaimsAnOnsetButKeepsThePace) {
  ManualClock clock;
  SilentAudio audio{clock};
  EXPECT_EQ(audio.kind(), "none");
  audio.schedule(sound_of(48'000), Instant{seconds{1}});
  clock.set(milliseconds{1500});
  EXPECT_FALSE(audio.playback().onset.has_value());
  EXPECT_FALSE(audio.playback().finished);
  EXPECT_EQ(audio.playback().source, "none");
  clock.set(seconds{2});
  EXPECT_TRUE(audio.playback().finished);
  EXPECT_FALSE(audio.playback().onset.has_value());
  audio.schedule(sound_of(48'000), Instant{seconds{5}});
  audio.stop();
  EXPECT_TRUE(audio.playback().finished);
}

Sound sound_with(std::vector<float> samples) {
  return {Hertz{48'000}, std::make_shared<const std::vector<float>>(std::move(samples))};
}

TEST(SilentHead, IsWhatIsExactlySilentBeforeSoundAndMarker) {
  EXPECT_EQ(count_silent_head(sound_with({0, 0, 1e-30F, 0})), 2);
  EXPECT_EQ(count_silent_head(sound_with({1, 0})), 0);
  EXPECT_EQ(count_silent_head(sound_with({0, 0, 0})), 2);
  EXPECT_EQ(count_silent_head(sound_with({})), 0);
  auto marked = sound_with({0, 0, 0, 1});
  marked.marker = Marker{.samples = marked.samples, .start = 1, .channels = {}};
  EXPECT_EQ(count_silent_head(marked), 1);
}

TEST(SimulatedAudio, MovesASoundThatHasNotBegun) {
  ManualClock clock;
  SimulatedAudio audio{clock};
  audio.schedule(sound_of(48'000), Instant{milliseconds{100}});
  audio.move(Instant{milliseconds{130}});
  clock.set(milliseconds{129});
  EXPECT_FALSE(audio.playback().onset);
  clock.set(milliseconds{130});
  EXPECT_EQ(audio.playback().onset, Instant{milliseconds{130}});
  audio.move(Instant{milliseconds{500}});
  EXPECT_EQ(audio.playback().onset, Instant{milliseconds{130}});
}

}  // namespace
}  // namespace bimodal::runner
