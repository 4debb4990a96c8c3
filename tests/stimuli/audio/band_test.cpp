#include "stimuli/audio/band.hpp"

#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "tests/stimuli/audio/signals.hpp"

namespace bimodal {
namespace {

using testing_signals::repeatable;
using testing_signals::sine;

constexpr Band kSpeechBand{Hertz{80}, Hertz{8000}};
constexpr Band kWholeBand48{Hertz{0}, Hertz{24'000}};

TEST(Level, IsMinusNineDecibelsForAHalfScaleSine) {
  // sox -n -r 48000 -b 32 -e floating-point s.wav synth 1 sine 1000 vol 0.5
  // sox s.wav -n stats  ->  RMS lev dB -9.03
  FourierTransform fourier;
  const auto samples = sine(48'000, 48'000, 1000, 0.5);
  EXPECT_NEAR(level(samples).count(), -9.03, 0.005);
  EXPECT_NEAR(band_level(samples, Hertz{48'000}, kSpeechBand, fourier).count(), -9.0309, 1e-4);
}

TEST(BandLevel, AgreesWithNumpyForNoiseOfAnAwkwardLength) {
  // X = numpy.fft.fft(x, 7200); f = abs(numpy.fft.fftfreq(7200, 1/rate))
  // 10*log10(sum(abs(X[(f >= 80) & (f <= 8000)])**2) / 7200 / 7000), x in 64 bits
  FourierTransform fourier;
  const auto samples = repeatable(7000);
  const auto in_band = [&](double rate) {
    return band_level(samples, Hertz{rate}, kSpeechBand, fourier).count();
  };
  EXPECT_NEAR(in_band(16'000), -4.795836069, 1e-5);
  EXPECT_NEAR(in_band(44'100), -9.145693597, 1e-5);
  EXPECT_NEAR(in_band(48'000), -9.497576687, 1e-5);
}

TEST(BandLevel, OverTheWholeSpectrumIsTheLevelInTime) {
  FourierTransform fourier;
  Random random{5};
  for (int i = 0; i < 50; ++i) {
    std::vector<float> samples(1 + random.below(3000));
    for (auto& sample : samples) sample = static_cast<float>(random.normal());
    EXPECT_NEAR(band_level(samples, Hertz{48'000}, kWholeBand48, fourier).count(),
                level(samples).count(),
                1e-4);
  }
}

TEST(BandLevel, IncludesBothEdges) {
  FourierTransform fourier;  // 48 000 samples at 48 kHz: one bin per Hertz
  const auto at = [&](double frequency) {
    return band_level(sine(48'000, 48'000, frequency, 1.0), Hertz{48'000}, kSpeechBand, fourier)
        .count();
  };
  EXPECT_NEAR(at(80), -3.0103, 1e-3);
  EXPECT_NEAR(at(8000), -3.0103, 1e-3);
  EXPECT_LT(at(79), -90.0);
  EXPECT_LT(at(8001), -90.0);
}

TEST(BandLevel, CountsTheBinsAtZeroAndAtHalfTheRateOnce) {
  FourierTransform fourier;
  std::vector<float> constant(1000, 0.5F);
  EXPECT_NEAR(band_level(constant, Hertz{48'000}, kWholeBand48, fourier).count(), -6.0206, 1e-4);
  for (std::size_t i = 1; i < constant.size(); i += 2) constant[i] = -0.5F;
  EXPECT_NEAR(band_level(constant, Hertz{48'000}, kWholeBand48, fourier).count(), -6.0206, 1e-4);
}

TEST(BandLevel, AddsThePowersOfSeparateBands) {
  FourierTransform fourier;
  const auto samples = repeatable(6000);  // 8 Hz per bin; 4004 Hz lies between two bins
  const auto power = [&](double low, double high) {
    const auto found = band_level(samples, Hertz{48'000}, {Hertz{low}, Hertz{high}}, fourier);
    return std::pow(10.0, found.count() / 10.0);
  };
  EXPECT_NEAR(power(80, 4004) + power(4004, 8000), power(80, 8000), 1e-9);
}

TEST(BandLevel, IsMinusInfinityForSilence) {
  FourierTransform fourier;
  const std::vector<float> silence(100);
  const double minus_infinity = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(band_level(silence, Hertz{48'000}, kSpeechBand, fourier).count(), minus_infinity);
  EXPECT_EQ(band_level({}, Hertz{48'000}, kSpeechBand, fourier).count(), minus_infinity);
}

TEST(BandLevel, RefusesABandAboveHalfTheSamplingRate) {
  FourierTransform fourier;
  try {
    (void)band_level(repeatable(10), Hertz{8000}, kSpeechBand, fourier);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(
        error.what(),
        "cannot measure the band 80 to 8000 Hz in sound of 8000 samples per second; choose "
        "edges in rising order, the upper at most half the sampling rate, or a higher "
        "rate");
  }
  EXPECT_THROW(require_band({Hertz{500}, Hertz{500}}, Hertz{48'000}), Error);
  EXPECT_THROW(require_band({Hertz{-1}, Hertz{500}}, Hertz{48'000}), Error);
  EXPECT_THROW(require_band({Hertz{80}, Hertz{std::nan("")}}, Hertz{48'000}), Error);
}

TEST(Cut, TakesFromTheNearestSampleToTheNearestSample) {
  const Clip sound{Hertz{1000}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}};
  using std::chrono::microseconds;
  const auto part = cut(sound, {microseconds{2400}, microseconds{5500}});
  ASSERT_EQ(part.size(), 4U);
  EXPECT_EQ(part.front(), 2.0F);
  EXPECT_EQ(cut(sound, {Duration{}, sound.duration()}).size(), 10U);
}

TEST(Cut, RefusesWhatIsEmptyOrOutside) {
  const Clip sound{Hertz{1000}, std::vector<float>(10)};
  using std::chrono::milliseconds;
  EXPECT_THROW((void)cut(sound, {milliseconds{3}, milliseconds{3}}), Error);
  EXPECT_THROW((void)cut(sound, {milliseconds{5}, milliseconds{3}}), Error);
  EXPECT_THROW((void)cut(sound, {milliseconds{-2}, milliseconds{3}}), Error);
  EXPECT_THROW((void)cut(sound, {milliseconds{3}, milliseconds{12}}), Error);
  EXPECT_THROW((void)cut(sound, {milliseconds{10}, milliseconds{11}}), Error);
}

TEST(FastLength, IsTheNextEvenProductOfTwoThreeAndFive) {
  const auto is_product = [](std::size_t n) {
    for (const std::size_t p : {2U, 3U, 5U}) {
      while (n % p == 0) n /= p;
    }
    return n == 1;
  };
  for (std::size_t n = 0; n < 3000; ++n) {
    std::size_t expected = std::max<std::size_t>(n, 2);
    while (expected % 2 != 0 || !is_product(expected)) ++expected;
    ASSERT_EQ(fast_length(n), expected);
  }
}

TEST(CommonFastLength, IsAmongFewForSoundsOfOneToThreeSeconds) {
  std::set<std::size_t> lengths;
  for (std::size_t n = 48'000; n <= 144'000; ++n) {
    const auto length = common_fast_length(n);
    ASSERT_GE(length, n);
    ASSERT_LE(length, n + n / 8);
    ASSERT_EQ(length % 2048, 0U);
    lengths.insert(length);
  }
  EXPECT_LE(lengths.size(), 20U);
}

TEST(FourierTransform, TurnsASpectrumBackIntoItsSignal) {
  FourierTransform fourier;
  const auto samples = repeatable(480);
  const auto bins = fourier.forward(samples);
  const std::vector<std::complex<float>> kept{bins.begin(), bins.end()};
  std::ranges::copy(kept, fourier.empty_spectrum(480).begin());
  const auto again = fourier.inverse();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_NEAR(again[i] / 480.0F, samples[i], 1e-5F);
  }
}

}  // namespace
}  // namespace bimodal
