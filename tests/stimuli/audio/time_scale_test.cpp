#include "stimuli/audio/time_scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "stimuli/audio/band.hpp"
#include "stimuli/audio/fourier.hpp"
#include "stimuli/audio/sound_file.hpp"
#include "stimuli/base/error.hpp"
#include "synth/voice/voice.hpp"
#include "tests/stimuli/audio/signals.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;

constexpr Hertz kRate{48'000};

/// Ten harmonics of one tone, equally strong, their phases spread.
Clip harmonic_tone(double frequency, double seconds) {
  Clip made{kRate, {}};
  made.samples.resize(static_cast<std::size_t>(seconds * kRate.count()));
  for (std::size_t n = 0; n < made.samples.size(); ++n) {
    const double turns = frequency * static_cast<double>(n) / kRate.count();
    double sum = 0.0;
    for (int k = 1; k <= 10; ++k) {
      sum += 0.05 * std::sin(2.0 * std::numbers::pi * k * turns + k * k);
    }
    made.samples[n] = static_cast<float>(sum);
  }
  return made;
}

/// The frequency between 80 and 500 Hz at which the middle half of the sound resembles itself most.
double pitch_of(const Clip& sound) {
  const auto middle =
      std::span{sound.samples}.subspan(sound.samples.size() / 4, sound.samples.size() / 2);
  const auto shortest = static_cast<std::size_t>(sound.rate.count() / 500.0);
  const auto longest = static_cast<std::size_t>(sound.rate.count() / 80.0);
  std::size_t best = shortest;
  double highest = -1.0;
  for (std::size_t lag = shortest; lag <= longest; ++lag) {
    double product = 0.0;
    double early = 0.0;
    double late = 0.0;
    for (std::size_t i = 0; i + longest < middle.size(); ++i) {
      const double a = static_cast<double>(middle[i]);
      const double b = static_cast<double>(middle[i + lag]);
      product += a * b;
      early += a * a;
      late += b * b;
    }
    const double likeness = product / std::sqrt(early * late);
    if (likeness > highest + 0.01) {  // a multiple of the period is as good: take the first
      highest = likeness;
      best = lag;
    } else if (likeness > highest && lag - best < 3) {
      highest = likeness;
      best = lag;
    }
  }
  return sound.rate.count() / static_cast<double>(best);
}

/// Of a burst of amplitude 0.5 about `expected` seconds: when the RMS over 2 ms passes half of its
/// own for the first and for the last time.
struct Edges {
  double on = 0.0;
  double off = 0.0;
};

Edges edges_near(const Clip& sound, double expected, double length, double reach) {
  constexpr std::size_t kWindow = 96;
  const double threshold = 0.5 * 0.5 / std::numbers::sqrt2;
  const auto place = [&](double seconds) {
    return static_cast<std::size_t>(std::max(seconds, 0.0) * sound.rate.count());
  };
  Edges edges{.on = -1.0, .off = -1.0};
  const auto last = std::min(place(expected + length + reach), sound.samples.size() - kWindow);
  for (auto i = place(expected - reach); i < last; ++i) {
    const double level = testing_signals::rms(std::span{sound.samples}.subspan(i, kWindow));
    if (level < threshold) continue;
    const double instant = static_cast<double>(i + kWindow / 2) / sound.rate.count();
    if (edges.on < 0.0) edges.on = instant;
    edges.off = instant;
  }
  return edges;
}

TEST(TimeScale, HasTheNearestNumberOfSamplesAtEveryRate) {
  for (const double rate : {0.25, 1.0 / 3.0, 0.7, 0.999, 1.1, 2.0, 3.0, 4.0}) {
    for (const std::size_t samples : {0U, 1U, 4'801U}) {
      const auto made = change_rate({kRate, testing_signals::repeatable(samples)}, rate);
      const auto exact = static_cast<double>(samples) / rate;
      EXPECT_EQ(made.samples.size(), static_cast<std::size_t>(std::floor(exact + 0.5)));
      EXPECT_EQ(made.rate, kRate);
    }
  }
}

TEST(TimeScale, ReturnsTheVerySamplesAtRateOne) {
  const Clip sound{kRate, testing_signals::repeatable(5'000)};
  EXPECT_EQ(change_rate(sound, 1.0).samples, sound.samples);
}

TEST(TimeScale, IsTheSameBitForBitEveryTime) {
  const Clip sound{Hertz{16'000}, testing_signals::repeatable(20'000)};
  EXPECT_EQ(change_rate(sound, 1.7).samples, change_rate(sound, 1.7).samples);
}

TEST(TimeScale, PutsOnsetsAndOffsetsWhereTheyBelong) {
  constexpr double kLength = 0.06;
  Clip sound{kRate, std::vector<float>(3 * 48'000, 0.0F)};
  const auto burst = testing_signals::sine(2'880, kRate.count(), 1000.0, 0.5);
  std::vector<double> onsets;
  for (double onset = 0.0; onset < 2.8; onset += 0.26 + 0.03 * onset) {
    onsets.push_back(onset);
    std::ranges::copy(burst, sound.samples.begin() + static_cast<std::ptrdiff_t>(onset * 48'000));
  }
  for (const double rate : {1.0 / 3.0, 0.7, 1.5, 2.0, 3.0, 4.0}) {
    const auto made = change_rate(sound, rate);
    const double allowed = rate < 0.7 ? 0.015 : 0.005;
    for (const double onset : onsets) {
      const auto edges = edges_near(made, onset / rate, kLength / rate, 0.1 / rate);
      EXPECT_NEAR(edges.on, onset / rate, allowed) << "rate " << rate;
      EXPECT_NEAR(edges.off, (onset + kLength) / rate, allowed) << "rate " << rate;
    }
  }
}

TEST(TimeScale, PutsASingleSampleWhereItBelongs) {
  Clip sound{kRate, std::vector<float>(48'000, 0.0F)};
  sound.samples[20'000] = 0.9F;
  for (const double rate : {0.7, 1.5, 3.0}) {
    const auto made = change_rate(sound, rate);
    double energy = 0.0;
    double moment = 0.0;
    for (std::size_t i = 0; i < made.samples.size(); ++i) {
      const double power =
          static_cast<double>(made.samples[i]) * static_cast<double>(made.samples[i]);
      energy += power;
      moment += power * static_cast<double>(i);
    }
    EXPECT_GT(energy, 0.0);
    EXPECT_NEAR(moment / energy / 48'000, 20'000 / rate / 48'000, 0.005) << "rate " << rate;
  }
}

TEST(TimeScale, KeepsPitchAndLevel) {
  const auto sound = harmonic_tone(200.0, 1.0);
  ASSERT_NEAR(pitch_of(sound), 200.0, 0.5);
  for (const double rate : {1.0 / 3.0, 0.7, 1.5, 3.0}) {
    const auto made = change_rate(sound, rate);
    EXPECT_NEAR(pitch_of(made), 200.0, 2.0) << "rate " << rate;
    const auto quarter = made.samples.size() / 4;
    const auto middle = std::span{made.samples}.subspan(quarter, 2 * quarter);
    EXPECT_NEAR(level(middle).count(), level(sound.samples).count(), 1.0) << "rate " << rate;
  }
}

TEST(TimeScale, MakesAWordOfATenthOfASecond) {
  const auto sound = harmonic_tone(200.0, 0.3);
  const auto made = change_rate(sound, 3.0);
  EXPECT_EQ(made.samples.size(), 4'800U);
  EXPECT_NEAR(level(made.samples).count(), level(sound.samples).count(), 1.0);
  EXPECT_NEAR(pitch_of(made), 200.0, 4.0);
}

TEST(TimeScale, KeepsTheSpectralEnvelopeOfSpeech) {
  const auto voices = synth::Voice::installed();
  if (voices.empty()) GTEST_SKIP() << "no voice of Festival is installed";
  const auto sound = synth::Voice{voices.front()}.speak("sheep").sound;
  FourierTransform fourier;
  const double highest = sound.rate.count() / 2.0;
  for (const double rate : {0.7, 1.5, 2.0}) {
    const auto made = change_rate(sound, rate);
    for (double low = 100.0; 2.0 * low <= highest; low *= 2.0) {
      const Band band{Hertz{low}, Hertz{2.0 * low}};
      EXPECT_NEAR(band_level(made.samples, made.rate, band, fourier).count(),
                  band_level(sound.samples, sound.rate, band, fourier).count(),
                  3.0)
          << "rate " << rate << " from " << low << " Hz";
    }
  }
}

TEST(TimeScale, AgreesWithSoxInLengthAndPitch) {
  if (std::system("command -v sox > /dev/null 2>&1") != 0) GTEST_SKIP() << "sox is absent";
  const auto folder = std::filesystem::path{testing::TempDir()} /
                      ("bimodal_time_scale_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const auto sound = harmonic_tone(137.0, 1.5);
  write_wav(folder / "in.wav", sound);
  for (const double rate : {0.7, 1.5, 2.5}) {
    const auto command = "sox -V1 -D '" + (folder / "in.wav").string() + "' -e float -b 32 '" +
                         (folder / "out.wav").string() + "' tempo -s " + std::to_string(rate);
    ASSERT_EQ(std::system(command.c_str()), 0);
    const auto theirs = read_sound(folder / "out.wav");
    const auto ours = change_rate(sound, rate);
    EXPECT_NEAR(static_cast<double>(theirs.samples.size()),
                static_cast<double>(ours.samples.size()),
                0.01 * static_cast<double>(ours.samples.size()));
    EXPECT_NEAR(pitch_of(theirs), pitch_of(ours), 1.37);
  }
  std::filesystem::remove_all(folder);
}

TEST(TimeScale, LeavesSilenceSilent) {
  const auto made = change_rate({kRate, std::vector<float>(10'000, 0.0F)}, 0.6);
  EXPECT_TRUE(std::ranges::all_of(made.samples, [](float sample) { return sample == 0.0F; }));
}

TEST(TimeScale, RefusesRatesAtWhichSpeechIsNoSpeech) {
  const Clip sound{kRate, {0.0F, 1.0F}};
  for (const double rate : {0.0, -1.0, 0.2499, 4.001, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW((void)change_rate(sound, rate), Error) << rate;
    EXPECT_THROW((void)change_rate(Utterance{}, rate), Error) << rate;
  }
}

TEST(TimeScale, MovesThePhonesWithTheSoundAndLeavesNoGaps) {
  const Utterance utterance{{{Phone::Rest, 0ms, 101ms},
                             {Phone::S, 101ms, 73ms},
                             {Phone::UW, 174ms, 200ms},
                             {Phone::Rest, 374ms, 26ms}}};
  const auto made = change_rate(utterance, 3.0);
  EXPECT_EQ(made.phones[1].start, Duration{33'666'667});
  EXPECT_EQ(made.phones[1].end(), Duration{58'000'000});
  EXPECT_EQ(made.end(), Duration{133'333'333});
  for (std::size_t i = 1; i < made.phones.size(); ++i) {
    EXPECT_EQ(made.phones[i].start, made.phones[i - 1].end());
  }
  EXPECT_EQ(change_rate(utterance, 1.0), utterance);
}

TEST(TimeScale, TurnsSoundAndPhonesRound) {
  EXPECT_EQ(reversed(Clip{kRate, {1.0F, 2.0F, 3.0F}}).samples,
            (std::vector<float>{3.0F, 2.0F, 1.0F}));
  const Utterance utterance{
      {{Phone::Rest, 0ms, 10ms}, {Phone::S, 10ms, 30ms}, {Phone::UW, 40ms, 5ms}}};
  EXPECT_EQ(reversed(utterance),
            (Utterance{{{Phone::UW, 0ms, 5ms}, {Phone::S, 5ms, 30ms}, {Phone::Rest, 35ms, 10ms}}}));
  EXPECT_EQ(reversed(reversed(utterance)), utterance);
}

TEST(TimeScale, GatesWithARaisedCosineBeforeTheInstant) {
  const Clip ones{Hertz{1'000}, std::vector<float>(20, 1.0F)};
  const auto made = gated(ones, 10ms, 4ms);
  ASSERT_EQ(made.samples.size(), 20U);
  EXPECT_EQ(made.samples[6], 1.0F);
  EXPECT_NEAR(made.samples[7], 0.5 * (1.0 + std::numbers::sqrt2 / 2.0), 1e-6);
  EXPECT_NEAR(made.samples[8], 0.5, 1e-6);
  EXPECT_EQ(made.samples[10], 0.0F);
  EXPECT_EQ(made.samples[19], 0.0F);
  EXPECT_EQ(gated(ones, 10ms, 0ms).samples[9], 1.0F);
  EXPECT_EQ(gated(ones, 10ms, 0ms).samples[10], 0.0F);
  EXPECT_EQ(gated(ones, 30ms, 5ms).samples, ones.samples);
  EXPECT_EQ(gated(ones, 0ms, 5ms).samples, std::vector<float>(20, 0.0F));
  EXPECT_THROW((void)gated(ones, -1ms, 0ms), Error);
  EXPECT_THROW((void)gated(ones, 1ms, -1ms), Error);
}

}  // namespace
}  // namespace bimodal
