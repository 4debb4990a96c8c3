#include "stimuli/audio/speech_detector.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;

constexpr Hertz kRate{48'000};

/// Gaussian noise of an RMS of `level`.
std::vector<float> room(Duration length, double level_db, Seed seed = 1) {
  Random random{seed};
  std::vector<float> samples(static_cast<std::size_t>(nearest_sample(length, kRate).count()));
  const double rms = std::pow(10.0, level_db / 20.0);
  std::ranges::generate(samples, [&] { return static_cast<float>(rms * random.normal()); });
  return samples;
}

/// Adds a tone of 500 Hz and an RMS of `level_db`.
void speak(std::vector<float>& samples, Duration from, Duration to, double level_db) {
  const auto end = static_cast<std::size_t>(nearest_sample(to, kRate).count());
  const double peak = std::numbers::sqrt2 * std::pow(10.0, level_db / 20.0);
  for (auto i = static_cast<std::size_t>(nearest_sample(from, kRate).count()); i < end; ++i) {
    const double phase = 2.0 * std::numbers::pi * 500.0 * static_cast<double>(i) / kRate.count();
    samples[i] += static_cast<float>(peak * std::sin(phase));
  }
}

SpeechDetector heard(const std::vector<float>& samples, double room_db) {
  SpeechDetector detector{kRate, Decibels{room_db}};
  detector.feed(samples);
  return detector;
}

TEST(RoomLevel, IsTheRmsOfSteadyNoise) {
  // Of white noise, the 80 Hz below the edge are 1/300 of the power: 0.015 dB.
  EXPECT_NEAR(room_level({kRate, room(2s, -60.0)}).count(), -60.0, 0.1);
}

TEST(RoomLevel, IsDeafToAnOffsetToRumbleAndToASlammedDoor) {
  auto samples = room(2s, -60.0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double at = static_cast<double>(i) / kRate.count();
    samples[i] += static_cast<float>(0.1 + 0.003 * std::sin(2.0 * std::numbers::pi * 8.0 * at));
  }
  speak(samples, 900ms, 1200ms, -20.0);
  EXPECT_NEAR(room_level({kRate, samples}).count(), -60.0, 0.2);
}

TEST(RoomLevel, OfSilenceOrOfNothingIsTheLowest) {
  EXPECT_EQ(room_level({kRate, std::vector<float>(48'000)}).count(), -120.0);
  EXPECT_EQ(room_level({kRate, {}}).count(), -120.0);
}

TEST(RumbleFilter, HasTheGainOfASecondOrderButterworth) {
  // |H|^2 = 1 / (1 + (edge / f)^4); the bilinear transform changes nothing visible at 48 kHz.
  for (const double frequency : {20.0, 80.0, 160.0, 1000.0}) {
    RumbleFilter filter{kRate};
    double sum = 0.0;
    constexpr int kSamples = 96'000;
    for (int i = 0; i < 2 * kSamples; ++i) {
      const double phase = 2.0 * std::numbers::pi * frequency * i / kRate.count();
      const double out = filter(static_cast<float>(std::sin(phase)));
      if (i >= kSamples) sum += out * out;
    }
    const double expected = 0.5 / (1.0 + std::pow(80.0 / frequency, 4.0));
    EXPECT_NEAR(10.0 * std::log10(sum / kSamples / expected), 0.0, 0.01) << frequency;
  }
}

TEST(SpeechDetector, FindsAWordToAFrame) {
  auto samples = room(2s, -60.0);
  speak(samples, 500ms, 900ms, -25.0);
  const auto detector = heard(samples, -60.0);
  ASSERT_TRUE(detector.speech());
  EXPECT_EQ(detector.speech()->start, 500ms);
  // The filter rings on where a tone breaks off.
  EXPECT_GE(detector.speech()->end, 900ms);
  EXPECT_LE(detector.speech()->end, 910ms);
  EXPECT_EQ(detector.silence(), 2s - detector.speech()->end);
  EXPECT_EQ(detector.heard(), 2s);
}

TEST(SpeechDetector, HearsNothingInTheRoom) {
  for (Seed seed = 1; seed <= 50; ++seed) {
    const auto detector = heard(room(5s, -50.0, seed), -50.0);
    EXPECT_FALSE(detector.speech()) << seed;
    EXPECT_FALSE(detector.silence());
  }
}

TEST(SpeechDetector, IgnoresAClickButNotTheReleaseOfAFinalStop) {
  auto samples = room(2s, -60.0);
  speak(samples, 200ms, 220ms, -20.0);
  EXPECT_FALSE(heard(samples, -60.0).speech());
  speak(samples, 500ms, 800ms, -25.0);
  speak(samples, 920ms, 950ms, -35.0);
  const auto detector = heard(samples, -60.0);
  ASSERT_TRUE(detector.speech());
  EXPECT_EQ(detector.speech()->start, 500ms);
  EXPECT_GE(detector.speech()->end, 950ms);
  EXPECT_LE(detector.speech()->end, 960ms);
}

TEST(SpeechDetector, DoesNotTakeSilenceOfZerosForAnInfinitelyQuietRoom) {
  auto samples = room(1s, -90.0);
  samples.resize(96'000);
  EXPECT_FALSE(heard(samples, -120.0).speech());
}

TEST(SpeechDetector, TellsTheSameHoweverTheSamplesCome) {
  auto samples = room(1s, -60.0);
  speak(samples, 300ms, 700ms, -25.0);
  const auto whole = heard(samples, -60.0);
  Random random{9};
  SpeechDetector parts{kRate, Decibels{-60.0}};
  for (std::size_t at = 0; at < samples.size();) {
    const auto count = std::min<std::size_t>(random.below(2000), samples.size() - at);
    parts.feed(std::span{samples}.subspan(at, count));
    at += count;
  }
  EXPECT_EQ(parts.speech()->start, whole.speech()->start);
  EXPECT_EQ(parts.speech()->end, whole.speech()->end);
  EXPECT_EQ(parts.heard(), whole.heard());
}

TEST(SpeechDetector, CountsFramesRightWhereTheRateIsNoMultipleOfAHundred) {
  SpeechDetector detector{Hertz{11'025}, Decibels{-60.0}};
  detector.feed(std::vector<float>(11'025 * 3));
  EXPECT_EQ(detector.heard(), 3s);
}

}  // namespace
}  // namespace bimodal
