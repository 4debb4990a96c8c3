#include "stimuli/audio/noise.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "tests/stimuli/audio/signals.hpp"

namespace bimodal {
namespace {

using testing_signals::power_at;
using testing_signals::rms;

NoiseRequest request(std::size_t samples, double rate, Seed seed) {
  return {.samples = samples,
          .rate = Hertz{rate},
          .band = {},
          .level = Decibels{-20.0},
          .ramp = 0,
          .seed = seed};
}

TEST(BandNoise, HasNoPowerOutsideItsBandAtAnyRate) {
  FourierTransform fourier;
  for (const double rate : {16'000.0, 44'100.0, 48'000.0, 96'000.0}) {
    const std::size_t length = 7200;  // a fast length: the noise is one whole period
    const auto noise = band_noise(request(length, rate, 3), fourier);
    const double spacing = rate / static_cast<double>(length);
    // mean power per bin in the band if all of the power is in it
    const double bins_in_band = 7920.0 / spacing;
    const double mean = 0.01 * static_cast<double>(length * length) / (2.0 * bins_in_band);
    for (std::size_t k = 0; k <= length / 2; k += 7) {
      const double frequency = static_cast<double>(k) * spacing;
      if (frequency >= 80.0 && frequency <= 8000.0) continue;
      EXPECT_LT(power_at(noise, rate, frequency), 1e-9 * mean) << frequency << " Hz at " << rate;
    }
  }
}

TEST(BandNoise, IsWhiteWithinItsBand) {
  FourierTransform fourier;
  const auto noise = band_noise(request(480'000, 48'000, 11), fourier);
  const double width = 7920.0 / 6.0;
  for (int part = 0; part < 6; ++part) {
    const double low = 80.0 + width * part;
    const auto found =
        band_level(noise, Hertz{48'000}, {Hertz{low}, Hertz{low + width}}, fourier).count();
    // 13 200 bins: the standard error of the power is 0.038 dB
    EXPECT_NEAR(found, -20.0 - 10.0 * std::log10(6.0), 0.15);
  }
}

TEST(BandNoise, HasTheSkewnessAndKurtosisOfANormalDistribution) {
  FourierTransform fourier;
  const auto noise = band_noise(request(480'000, 16'000, 12), fourier);
  const double scale = rms(noise);
  double cubes = 0.0;
  double fourths = 0.0;
  for (const float sample : noise) {
    const double standard = static_cast<double>(sample) / scale;
    cubes += std::pow(standard, 3);
    fourths += std::pow(standard, 4);
  }
  const auto n = static_cast<double>(noise.size());
  EXPECT_NEAR(cubes / n, 0.0, 4.0 * std::sqrt(6.0 / n));
  EXPECT_NEAR(fourths / n, 3.0, 4.0 * std::sqrt(24.0 / n));
}

TEST(BandNoise, HasExactlyTheLevelBetweenItsRampsWhateverTheirLength) {
  FourierTransform fourier;
  for (const std::size_t ramp : {0U, 1U, 240U, 2400U, 20'000U}) {
    auto wanted = request(71'003, 48'000, 4);
    wanted.ramp = ramp;
    const auto noise = band_noise(wanted, fourier);
    ASSERT_EQ(noise.size(), 71'003U);
    const auto steady = std::span{noise}.subspan(ramp, noise.size() - 2 * ramp);
    EXPECT_NEAR(20.0 * std::log10(rms(steady)), -20.0, 1e-5);
    EXPECT_NEAR(band_level(steady, Hertz{48'000}, wanted.band, fourier).count(), -20.0, 1e-3);
  }
}

TEST(BandNoise, RisesAndFallsAsARaisedCosine) {
  FourierTransform fourier;
  auto wanted = request(4800, 48'000, 4);
  const auto flat = band_noise(wanted, fourier);
  wanted.ramp = 480;
  const auto ramped = band_noise(wanted, fourier);
  const float gain = ramped[2400] / flat[2400];
  EXPECT_NEAR(ramped[0] / (gain * flat[0]), 2.677e-6, 1e-8);  // sin(pi / 1920)^2
  EXPECT_NEAR(ramped[239] / (gain * flat[239]), 0.49836, 1e-4);
  EXPECT_NEAR(ramped[240] / (gain * flat[240]), 0.50164, 1e-4);
  EXPECT_NEAR(ramped[4799] / (gain * flat[4799]), 2.677e-6, 1e-8);
}

TEST(BandNoise, IsTheSameForTheSameSeedAndUnrelatedForAnother) {
  FourierTransform fourier;
  FourierTransform another;
  const auto first = band_noise(request(30'000, 48'000, 7), fourier);
  EXPECT_EQ(first, band_noise(request(30'000, 48'000, 7), another));
  const auto other = band_noise(request(30'000, 48'000, 8), fourier);
  double product = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i)
    product += static_cast<double>(first[i] * other[i]);
  // 30 000 samples at 48 kHz hold 2 * 7920 * 0.625 independent values: standard error 0.01
  EXPECT_NEAR(product / 30'000.0 / 0.01, 0.0, 0.04);
}

TEST(BandNoise, RefusesRampsThatLeaveNothingBetweenThem) {
  FourierTransform fourier;
  auto wanted = request(100, 48'000, 1);
  wanted.ramp = 50;
  EXPECT_THROW((void)band_noise(wanted, fourier), Error);
  EXPECT_THROW((void)band_noise(request(0, 48'000, 1), fourier), Error);
}

TEST(BandNoise, RefusesABandWithoutAnyComponent) {
  FourierTransform fourier;
  auto wanted = request(48, 48'000, 1);  // one component per 1000 Hz
  wanted.band = {Hertz{1100}, Hertz{1900}};
  EXPECT_THROW((void)band_noise(wanted, fourier), Error);
}

}  // namespace
}  // namespace bimodal
