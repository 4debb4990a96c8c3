#include "runner/realtime/mixer.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <numeric>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"
#include "tests/runner/realtime/count_allocations.hpp"

namespace bimodal::runner {
namespace {

constexpr std::int64_t kFade = 240;

std::vector<float> ramp(std::size_t length) {
  std::vector<float> samples(length);
  std::iota(samples.begin(), samples.end(), 1.0F);
  return samples;
}

MixerCommand start(std::uint64_t sound, const std::vector<float>& samples, std::int64_t at) {
  return {.kind = MixerCommand::Kind::Start,
          .sound = sound,
          .samples = samples.data(),
          .length = static_cast<std::int64_t>(samples.size()),
          .start = at};
}

std::vector<float> rendered(Mixer& mixer, std::size_t frames, std::size_t channels = 1) {
  std::vector<float> output(frames * channels, 99.0F);
  mixer.render(output, channels, false);
  return output;
}

void expect_report(Mixer& mixer, MixerReport::Kind kind, std::uint64_t sound, std::int64_t at) {
  const auto report = mixer.next_report();
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->kind, kind);
  EXPECT_EQ(report->sound, sound);
  EXPECT_EQ(report->at, at);
}

TEST(Mixer, IsSilentWithoutASound) {
  Mixer mixer{kFade};
  EXPECT_EQ(rendered(mixer, 64, 2), std::vector<float>(128, 0.0F));
  EXPECT_EQ(mixer.position(), 64);
  EXPECT_FALSE(mixer.next_report().has_value());
}

TEST(Mixer, PlacesASoundAtItsVerySampleHoweverTheStreamIsCutIntoBuffers) {
  Random random{31};
  for (int round = 0; round < 300; ++round) {
    const auto sound = ramp(1 + random.below(700));
    const auto at = static_cast<std::int64_t>(random.below(1500));
    const std::size_t channels = 1 + random.below(2);
    Mixer mixer{kFade};
    ASSERT_TRUE(mixer.post(start(7, sound, at)));
    std::vector<float> stream;
    while (stream.size() < 2500 * channels) {
      const auto buffer = rendered(mixer, 1 + random.below(400), channels);
      stream.insert(stream.end(), buffer.begin(), buffer.end());
    }
    for (std::size_t i = 0; i < stream.size(); ++i) {
      const auto index = static_cast<std::int64_t>(i / channels) - at;
      const bool within = index >= 0 && index < static_cast<std::int64_t>(sound.size());
      ASSERT_EQ(stream[i], within ? sound[static_cast<std::size_t>(index)] : 0.0F);
    }
    expect_report(mixer, MixerReport::Kind::Started, 7, at);
    expect_report(
        mixer, MixerReport::Kind::Finished, 7, at + static_cast<std::int64_t>(sound.size()));
  }
}

TEST(Mixer, StartsALateSoundAtOnceAndSaysWhere) {
  Mixer mixer{kFade};
  (void)rendered(mixer, 1000);
  const auto sound = ramp(10);
  ASSERT_TRUE(mixer.post(start(1, sound, 400)));
  EXPECT_EQ(rendered(mixer, 10), sound);  // whole, not cut
  expect_report(mixer, MixerReport::Kind::Started, 1, 1000);
  expect_report(mixer, MixerReport::Kind::Finished, 1, 1010);
}

MixerCommand move(std::uint64_t sound, std::int64_t to) {
  return {.kind = MixerCommand::Kind::Move, .sound = sound, .start = to};
}

TEST(Mixer, MovesASoundThatHasNotBegun) {
  Mixer mixer{kFade};
  const auto sound = ramp(3);
  ASSERT_TRUE(mixer.post(start(1, sound, 4)));
  (void)rendered(mixer, 2);
  ASSERT_TRUE(mixer.post(move(1, 7)));
  EXPECT_EQ(rendered(mixer, 8), (std::vector<float>{0, 0, 0, 0, 0, 1, 2, 3}));
  expect_report(mixer, MixerReport::Kind::Started, 1, 7);
}

TEST(Mixer, DoesNotMoveASoundThatPlaysNorAnother) {
  Mixer mixer{kFade};
  const auto sound = ramp(4);
  ASSERT_TRUE(mixer.post(start(1, sound, 0)));
  (void)rendered(mixer, 2);
  ASSERT_TRUE(mixer.post(move(1, 50)));
  ASSERT_TRUE(mixer.post(move(9, 50)));
  EXPECT_EQ(rendered(mixer, 3), (std::vector<float>{3, 4, 0}));
}

TEST(Mixer, FadesAStoppedSoundAsARaisedCosine) {
  Mixer mixer{kFade};
  const std::vector<float> sound(5000, 1.0F);
  ASSERT_TRUE(mixer.post(start(1, sound, 0)));
  (void)rendered(mixer, 100);
  ASSERT_TRUE(mixer.post({.kind = MixerCommand::Kind::Stop}));
  const auto output = rendered(mixer, 300);
  for (std::size_t i = 0; i < 300; ++i) {
    const double expected =
        i < 240 ? std::pow(std::cos(std::numbers::pi / 2 * static_cast<double>(i) / 240), 2) : 0.0;
    ASSERT_NEAR(output[i], expected, 1e-6);
  }
  expect_report(mixer, MixerReport::Kind::Started, 1, 0);
  expect_report(mixer, MixerReport::Kind::Finished, 1, 340);
}

TEST(Mixer, DropsAStoppedSoundThatHasNotStarted) {
  Mixer mixer{kFade};
  const auto sound = ramp(100);
  ASSERT_TRUE(mixer.post(start(1, sound, 5000)));
  (void)rendered(mixer, 100);
  ASSERT_TRUE(mixer.post({.kind = MixerCommand::Kind::Stop}));
  EXPECT_EQ(rendered(mixer, 6000), std::vector<float>(6000, 0.0F));
  expect_report(mixer, MixerReport::Kind::Finished, 1, 100);
  EXPECT_FALSE(mixer.next_report().has_value());
}

TEST(Mixer, FadesTheOldSoundWhenANewOneIsScheduled) {
  Mixer mixer{kFade};
  const std::vector<float> old_sound(5000, 1.0F);
  const std::vector<float> new_sound(100, 10.0F);
  ASSERT_TRUE(mixer.post(start(1, old_sound, 0)));
  (void)rendered(mixer, 100);
  ASSERT_TRUE(mixer.post(start(2, new_sound, 600)));
  const auto output = rendered(mixer, 1000);
  EXPECT_EQ(output[0], 1.0F);
  EXPECT_EQ(output[239 + 1], 0.0F);
  EXPECT_EQ(output[499], 0.0F);
  EXPECT_EQ(output[500], 10.0F);
  EXPECT_EQ(output[599], 10.0F);
  EXPECT_EQ(output[600], 0.0F);
}

ChannelSet channel_set(std::initializer_list<std::size_t> channels) {
  ChannelSet set;
  for (const auto channel : channels) set.add(channel);
  return set;
}

/// What one channel of an interleaved stream carries.
std::vector<float> channel_of(const std::vector<float>& stream,
                              std::size_t channel,
                              std::size_t channels) {
  std::vector<float> samples;
  for (auto i = channel; i < stream.size(); i += channels) samples.push_back(stream[i]);
  return samples;
}

TEST(Mixer, PlaysASoundOnItsChannelsAndLeavesAllOthersExactlySilent) {
  Random random{7};
  for (int round = 0; round < 100; ++round) {
    const std::size_t channels = 1 + random.below(8);
    ChannelSet wanted;
    for (std::size_t channel = 0; channel < 10; ++channel) {
      if (random.below(2) == 0) wanted.add(channel);  // also some that are not there
    }
    const auto sound = ramp(50);
    Mixer mixer{kFade};
    auto command = start(1, sound, 20);
    command.channels = wanted;
    ASSERT_TRUE(mixer.post(command));
    const auto stream = rendered(mixer, 100, channels);
    std::vector<float> heard(100, 0.0F);
    std::ranges::copy(sound, heard.begin() + 20);
    const std::vector<float> silence(100, 0.0F);
    for (std::size_t channel = 0; channel < channels; ++channel) {
      ASSERT_EQ(channel_of(stream, channel, channels), wanted.has(channel) ? heard : silence);
    }
  }
}

TEST(Mixer, PlaysBothEarsUnlessItIsToldOtherwise) {
  const auto sound = ramp(10);
  Mixer mixer{kFade};
  ASSERT_TRUE(mixer.post(start(1, sound, 0)));
  const auto stream = rendered(mixer, 10, 4);
  EXPECT_EQ(channel_of(stream, 0, 4), sound);
  EXPECT_EQ(channel_of(stream, 1, 4), sound);
  EXPECT_EQ(channel_of(stream, 2, 4), std::vector<float>(10, 0.0F));
  EXPECT_EQ(channel_of(stream, 3, 4), std::vector<float>(10, 0.0F));
}

/// A sound of 100 samples on channel 0 whose marker of 4 samples begins with its sample 30.
MixerCommand marked(const std::vector<float>& sound,
                    const std::vector<float>& marker,
                    std::int64_t at) {
  auto command = start(1, sound, at);
  command.channels = channel_set({0});
  command.marker = {.samples = marker.data(),
                    .length = static_cast<std::int64_t>(marker.size()),
                    .start = 30,
                    .channels = channel_set({2})};
  return command;
}

TEST(Mixer, PlaysTheMarkerAtItsVerySampleOfTheSoundHoweverTheStreamIsCutIntoBuffers) {
  Random random{8};
  const auto sound = ramp(100);
  const std::vector<float> marker(4, 0.5F);
  for (int round = 0; round < 100; ++round) {
    const auto at = random.below(300);
    Mixer mixer{kFade};
    ASSERT_TRUE(mixer.post(marked(sound, marker, static_cast<std::int64_t>(at))));
    std::vector<float> stream;
    while (stream.size() < 500 * 3) {
      const auto buffer = rendered(mixer, 1 + random.below(64), 3);
      stream.insert(stream.end(), buffer.begin(), buffer.end());
    }
    std::vector<float> clicks(stream.size() / 3, 0.0F);
    std::fill_n(clicks.begin() + static_cast<std::ptrdiff_t>(at) + 30, 4, 0.5F);
    ASSERT_EQ(channel_of(stream, 2, 3), clicks);
    ASSERT_EQ(channel_of(stream, 1, 3), std::vector<float>(clicks.size(), 0.0F));
    ASSERT_EQ(channel_of(stream, 0, 3)[at + 30], sound[30]);
  }
}

TEST(Mixer, PlaysTheMarkerLateByAsMuchAsTheSound) {
  const auto sound = ramp(100);
  const std::vector<float> marker(4, 0.5F);
  Mixer mixer{kFade};
  (void)rendered(mixer, 1000, 3);
  ASSERT_TRUE(mixer.post(marked(sound, marker, 400)));
  const auto clicks = channel_of(rendered(mixer, 64, 3), 2, 3);
  EXPECT_EQ(std::ranges::find(clicks, 0.5F) - clicks.begin(), 30);
  expect_report(mixer, MixerReport::Kind::Started, 1, 1000);
}

TEST(Mixer, FadesTheMarkerWithItsSound) {
  const std::vector<float> sound(1000, 1.0F);
  const std::vector<float> marker(900, 1.0F);
  Mixer mixer{kFade};
  ASSERT_TRUE(mixer.post(marked(sound, marker, 0)));
  (void)rendered(mixer, 100, 3);
  ASSERT_TRUE(mixer.post({.kind = MixerCommand::Kind::Stop}));
  const auto stream = rendered(mixer, 300, 3);
  EXPECT_EQ(channel_of(stream, 2, 3), channel_of(stream, 0, 3));
}

TEST(Mixer, PlaysAMarkerThatEndsAfterItsSoundToItsEnd) {
  const auto sound = ramp(32);
  const std::vector<float> marker(10, 0.5F);
  Mixer mixer{kFade};
  ASSERT_TRUE(mixer.post(marked(sound, marker, 0)));
  const auto clicks = channel_of(rendered(mixer, 64, 3), 2, 3);
  EXPECT_EQ(std::ranges::count(clicks, 0.5F), 10);
  expect_report(mixer, MixerReport::Kind::Started, 1, 0);
  expect_report(mixer, MixerReport::Kind::Finished, 1, 40);
}

TEST(Mixer, CountsTheUnderflowsOfASound) {
  Mixer mixer{kFade};
  const auto sound = ramp(300);
  std::vector<float> buffer(100);
  mixer.render(buffer, 1, true);  // before it
  ASSERT_TRUE(mixer.post(start(1, sound, 100)));
  mixer.render(buffer, 1, true);  // before its first sample
  mixer.render(buffer, 1, true);
  mixer.render(buffer, 1, false);
  mixer.render(buffer, 1, true);  // after it
  (void)mixer.next_report();
  const auto finished = mixer.next_report();
  ASSERT_TRUE(finished.has_value());
  EXPECT_EQ(finished->kind, MixerReport::Kind::Finished);
  EXPECT_EQ(finished->underflows, 1);
}

TEST(Mixer, LosesNoReportWhenNobodyReads) {
  Mixer mixer{kFade};
  const auto sound = ramp(5);
  std::uint64_t posted = 0;
  for (int i = 0; i < 200; ++i) {
    if (mixer.post(start(posted + 1, sound, 0))) ++posted;
    (void)rendered(mixer, 16);
  }
  EXPECT_LT(posted, 200U);  // it refuses rather than forgets
  std::uint64_t finished = 0;
  for (int i = 0; i < 2000; ++i) {
    while (const auto report = mixer.next_report()) {
      if (report->kind == MixerReport::Kind::Finished) {
        EXPECT_EQ(report->sound, ++finished);
      }
    }
    (void)rendered(mixer, 16);
  }
  EXPECT_EQ(finished, posted);
}

TEST(Mixer, DoesNotAllocateWhileRendering) {
  Mixer mixer{kFade};
  const auto sound = ramp(1000);
  const std::vector<float> marker(4, 0.5F);
  std::vector<float> buffer(256);
  const auto before = allocations_of_this_thread();
  for (std::uint64_t i = 0; i < 20; ++i) {
    (void)mixer.post(i % 2 == 0 ? start(i, sound, 0) : marked(sound, marker, 0));
    for (int k = 0; k < 3; ++k) mixer.render(buffer, 2, k == 1);
    while (mixer.next_report()) {
    }
  }
  EXPECT_EQ(allocations_of_this_thread(), before);
  static_assert(noexcept(mixer.render(buffer, 2, false)));
}

TEST(Mixer, IsCommandedFromAnotherThread) {
  Mixer mixer{kFade};
  std::atomic<bool> done{false};
  const std::jthread audio{[&] {
    std::vector<float> buffer(64);
    while (!done) {
      mixer.render(buffer, 1, false);
      std::this_thread::yield();
    }
  }};
  constexpr std::uint64_t kSounds = 500;
  std::uint64_t finished = 0;
  std::uint64_t posted = 0;
  std::vector<std::vector<float>> sounds(kSounds + 1);
  while (finished < kSounds) {
    if (posted < kSounds) {
      sounds[posted + 1] = ramp(50);
      if (mixer.post(start(posted + 1, sounds[posted + 1], 0))) ++posted;
    }
    while (const auto report = mixer.next_report()) {
      if (report->kind != MixerReport::Kind::Finished) continue;
      sounds[report->sound].clear();  // no longer borrowed
      sounds[report->sound].shrink_to_fit();
      ++finished;
    }
    std::this_thread::yield();
  }
  done = true;
}

}  // namespace
}  // namespace bimodal::runner
