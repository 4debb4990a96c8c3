#include "stimuli/audio/mix.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/audio/noise.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "tests/stimuli/audio/signals.hpp"

namespace bimodal {
namespace {

using std::chrono::milliseconds;
using testing_signals::power_at;
using testing_signals::rms;
using testing_signals::sine;

/// Something with the rough shape of a word: rest, tones with noise for 300 ms, rest.
Clip word(double rate, Seed seed) {
  Random random{seed};
  Clip clip{Hertz{rate}, std::vector<float>(static_cast<std::size_t>(rate * 0.6))};
  const double pitch = 90.0 + 100.0 * random.uniform();
  for (std::size_t n = 0; n < clip.samples.size(); ++n) {
    const double time = static_cast<double>(n) / rate;
    if (time < 0.15 || time > 0.45) continue;
    const double voice = std::sin(2 * std::numbers::pi * pitch * time) +
                         0.5 * std::sin(2 * std::numbers::pi * 7.3 * pitch * time);
    clip.samples[n] = static_cast<float>(0.1 * voice + 0.02 * random.normal());
  }
  return clip;
}

MixRequest request(const Clip& speech, std::optional<double> snr) {
  MixRequest wanted;
  wanted.speech = &speech;
  wanted.interval = {milliseconds{150}, milliseconds{450}};
  if (snr) wanted.snr = Decibels{*snr};
  wanted.noise_seed = 99;
  return wanted;
}

/// The mean power within 80 to 8000 Hz by summing the definition of the Fourier transform over a
/// grid of `step` Hz, independent of the code under test.
double level_by_definition(std::span<const float> samples, double rate, double step) {
  double sum = 0.0;
  for (double f = 80.0; f <= 8000.0; f += step) sum += power_at(samples, rate, f);
  return 10.0 * std::log10(2.0 * sum * step / rate / static_cast<double>(samples.size()));
}

TEST(Mix, HasTheSignalToNoiseRatioAskedForAtAnyRate) {
  FourierTransform fourier;
  for (const double rate : {16'000.0, 44'100.0, 48'000.0, 96'000.0}) {
    for (const double snr : {-20.0, -8.0, 0.0, 12.5}) {
      const auto speech = word(rate, 1);
      const auto both = mix(request(speech, snr), fourier).value();
      const auto alone = mix(request(speech, std::nullopt), fourier).value();
      Clip noise = both.sound;
      for (std::size_t i = 0; i < noise.samples.size(); ++i) {
        noise.samples[i] -= alone.sound.samples[i];
      }
      const auto heard = band_level(cut(alone.sound, both.speech), Hertz{rate}, {}, fourier);
      const auto steady = cut(noise, {milliseconds{50}, noise.duration() - milliseconds{50}});
      const auto masking = band_level(steady, Hertz{rate}, {}, fourier);
      EXPECT_NEAR((heard - masking).count(), snr, 0.01) << rate;
      EXPECT_NEAR(heard.count(), -26.0, 0.001);
      EXPECT_NEAR(20 * std::log10(rms(steady)), -26.0 - snr, 0.01);
    }
  }
}

TEST(Mix, HasThatRatioByTheDefinitionOfTheFourierTransformToo) {
  FourierTransform fourier;
  const auto speech = word(16'000, 2);
  auto wanted = request(speech, -8.0);
  wanted.lead = wanted.trail = milliseconds{100};
  const auto both = mix(wanted, fourier).value();
  wanted.snr.reset();
  const auto alone = mix(wanted, fourier).value();
  std::vector<float> noise = both.sound.samples;
  for (std::size_t i = 0; i < noise.size(); ++i) noise[i] -= alone.sound.samples[i];
  const auto heard = std::span{alone.sound.samples}.subspan(1600 + 2400, 4800);
  const auto steady = std::span{noise}.subspan(800, noise.size() - 1600);
  // 4800 samples at 16 kHz have one bin every 10/3 Hz
  const double difference =
      level_by_definition(heard, 16'000, 10.0 / 3.0) - level_by_definition(steady, 16'000, 1.0);
  EXPECT_NEAR(difference, -8.0, 0.01);
}

TEST(Mix, IsLeadThenRecordingThenTrail) {
  FourierTransform fourier;
  const auto speech = word(48'000, 3);
  auto wanted = request(speech, std::nullopt);
  wanted.lead = milliseconds{100};
  wanted.trail = milliseconds{250};
  const auto made = mix(wanted, fourier).value();
  ASSERT_EQ(made.sound.samples.size(), 4800U + 28'800U + 12'000U);
  EXPECT_EQ(made.sound.rate, Hertz{48'000});
  EXPECT_EQ(made.speech.start, milliseconds{250});
  EXPECT_EQ(made.speech.end, milliseconds{550});
  EXPECT_THAT(std::span{made.sound.samples}.first(4800), testing::Each(0.0F));
  EXPECT_THAT(std::span{made.sound.samples}.last(12'000), testing::Each(0.0F));
  const double gain =
      static_cast<double>(made.sound.samples[20'000]) / static_cast<double>(speech.samples[15'200]);
  for (std::size_t i = 240; i < 28'560; ++i) {
    ASSERT_NEAR(made.sound.samples[4800 + i], gain * static_cast<double>(speech.samples[i]), 1e-6);
  }
  EXPECT_FALSE(made.noise_dbfs.has_value());
  EXPECT_EQ(made.speech_dbfs, -26.0);
}

TEST(Mix, FadesTheEdgesOfTheRecordingOverFiveMilliseconds) {
  FourierTransform fourier;
  const Clip tone{Hertz{48'000}, std::vector<float>(9600, 0.25F)};  // starts and ends with a step
  auto wanted = request(tone, std::nullopt);
  wanted.interval = {milliseconds{20}, milliseconds{180}};
  wanted.band = {Hertz{0}, Hertz{8000}};
  wanted.lead = wanted.trail = Duration{};
  const auto made = mix(wanted, fourier).value().sound.samples;
  const float whole = made[4800];
  EXPECT_NEAR(made[0] / whole, 1.07e-5, 1e-6);  // sin(pi / 960)^2
  EXPECT_NEAR(made[120] / whole, 0.5033, 1e-3);
  EXPECT_EQ(made[240], whole);
  EXPECT_EQ(made[9359], whole);
  EXPECT_NEAR(made[9479] / whole, 0.5033, 1e-3);
}

TEST(Mix, FillsTheWholeSoundWithNoise) {
  FourierTransform fourier;
  const auto speech = word(48'000, 4);
  const auto made = mix(request(speech, -8.0), fourier).value();
  EXPECT_EQ(made.noise_dbfs, -18.0);
  for (const std::size_t from : {4800U, 14'000U, 60'000U, 70'000U}) {
    const auto part = std::span{made.sound.samples}.subspan(from, 4800);
    EXPECT_NEAR(20 * std::log10(rms(part)), -18.0, 1.0);
  }
}

TEST(Mix, IsTheSameForTheSameRequest) {
  FourierTransform fourier;
  FourierTransform another;
  const auto speech = word(44'100, 5);
  auto wanted = request(speech, -8.0);
  const auto first = mix(wanted, fourier).value();
  EXPECT_EQ(first.sound.samples, mix(wanted, another).value().sound.samples);
  EXPECT_EQ(sha256(first.sound), sha256(mix(wanted, fourier).value().sound));
  wanted.noise_seed += 1;
  EXPECT_NE(sha256(first.sound), sha256(mix(wanted, fourier).value().sound));
}

TEST(Mix, NeedsTheLevelOfARecordingOnlyOnce) {
  FourierTransform fourier;
  const auto speech = word(44'100, 6);
  auto wanted = request(speech, -8.0);
  const auto measured = mix(wanted, fourier).value();
  wanted.recording_level = measured.recording_level;
  EXPECT_EQ(mix(wanted, fourier).value().sound.samples, measured.sound.samples);
}

TEST(Mix, SaysHowManyDecibelsOfHeadroomAreLacking) {
  FourierTransform fourier;
  const auto speech = word(48'000, 6);
  auto wanted = request(speech, -8.0);
  const auto fitting = mix(wanted, fourier).value();
  EXPECT_LT(fitting.peak, 1.0);
  EXPECT_FALSE(headroom_lacking(fitting).has_value());

  wanted.speech_level = Decibels{-6.0};
  const auto loud = mix(wanted, fourier).value();
  EXPECT_GT(loud.peak, 1.0);  // nothing was clipped
  const auto lacking = headroom_lacking(loud).value();
  EXPECT_NEAR(lacking.count(), 20 * std::log10(loud.peak), 1e-9);
  wanted.speech_level = wanted.speech_level - lacking - Decibels{0.001};
  EXPECT_FALSE(headroom_lacking(mix(wanted, fourier).value()).has_value());
}

TEST(Mix, IsNothingWhereNothingIsSaid) {
  FourierTransform fourier;
  EXPECT_FALSE(mix(MixRequest{}, fourier).has_value());
}

TEST(Mix, RefusesSilenceAsSpeech) {
  FourierTransform fourier;
  const Clip silence{Hertz{48'000}, std::vector<float>(28'800)};
  try {
    (void)mix(request(silence, -8.0), fourier);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(
        error.what(),
        "cannot bring the speech to -26 dB: between 80 and 8000 Hz its interval is silent; "
        "check the recording and its labels");
  }
}

TEST(Mix, RefusesWhatCannotBeMixed) {
  FourierTransform fourier;
  const auto speech = word(48'000, 7);
  auto outside = request(speech, -8.0);
  outside.interval.end = milliseconds{700};
  EXPECT_THROW((void)mix(outside, fourier), Error);
  auto negative = request(speech, -8.0);
  negative.lead = milliseconds{-1};
  EXPECT_THROW((void)mix(negative, fourier), Error);
  auto ramps = request(speech, -8.0);
  ramps.ramp = std::chrono::seconds{1};
  EXPECT_THROW((void)mix(ramps, fourier), Error);
  auto broken = speech;
  broken.samples[12'000] = std::nanf("");
  EXPECT_THROW((void)mix(request(broken, -8.0), fourier), Error);
}

TEST(Mix, KeepsItsPromisesForRandomRequests) {
  FourierTransform fourier;
  Random random{2024};
  for (int i = 0; i < 40; ++i) {
    const double rate = 16'000.0 + static_cast<double>(random.below(40'000));
    const auto speech = word(rate, random.bits());
    auto wanted = request(speech, 40.0 * random.uniform() - 20.0);
    wanted.lead = milliseconds{random.below(300)};
    wanted.trail = milliseconds{random.below(300)};
    wanted.ramp = milliseconds{random.below(100)};
    wanted.speech_level = Decibels{-50.0 * random.uniform()};
    wanted.noise_seed = random.bits();
    const auto both = mix(wanted, fourier).value();
    EXPECT_NEAR(*both.noise_dbfs, both.speech_dbfs - wanted.snr->count(), 1e-12);
    wanted.snr.reset();
    const auto alone = mix(wanted, fourier).value();
    ASSERT_EQ(alone.sound.samples.size(), both.sound.samples.size());
    const auto heard = band_level(cut(alone.sound, alone.speech), Hertz{rate}, {}, fourier);
    EXPECT_NEAR(heard.count(), wanted.speech_level.count(), 0.002);
    std::vector<float> noise = both.sound.samples;
    for (std::size_t n = 0; n < noise.size(); ++n) noise[n] -= alone.sound.samples[n];
    const auto ramp = static_cast<std::size_t>(nearest_sample(wanted.ramp, Hertz{rate}).count());
    const auto steady = std::span{noise}.subspan(ramp, noise.size() - 2 * ramp);
    EXPECT_NEAR(level(steady).count(), *both.noise_dbfs, 0.002);
  }
}

TEST(Sha256OfASound, IsThatOfItsLittleEndianFloats) {
  // printf '\x00\x00\x80\x3f\x00\x00\x00\xbf' | sha256sum     (1.0, -0.5)
  EXPECT_EQ(sha256(Clip{Hertz{48'000}, {1.0F, -0.5F}}),
            "e5e0ce39fac89cd93af5ba8bcad2fe35d88c75417c7e44941fe5ee4e48f1cf75");
}

}  // namespace
}  // namespace bimodal
