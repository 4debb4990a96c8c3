#include "runner/calibration/calibration_sound.hpp"

#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

/// Of what lies between the ramps.
std::span<const float> steady(const Clip& clip) {
  return std::span{clip.samples}.subspan(4'800, clip.samples.size() - 9'600);
}

TEST(CalibrationSound, NoiseHasItsLevelWithinItsBand) {
  FourierTransform fourier;
  for (const double level : {-50.0, -30.0, -15.0}) {
    const Band band{.low = Hertz{100}, .high = Hertz{6'000}};
    const auto clip = made({.content = band, .level = Decibels{level}, .length = 4s});
    EXPECT_EQ(clip.samples.size(), 192'000U);
    EXPECT_NEAR(band_level(steady(clip), clip.rate, band, fourier).count(), level, 0.05);
  }
}

TEST(CalibrationSound, ToneHasItsLevel) {
  FourierTransform fourier;
  const auto clip = made({.content = Hertz{1'000}, .level = Decibels{-20}, .length = 2s});
  EXPECT_NEAR(level(steady(clip)).count(), -20, 0.01);
  const Band around{.low = Hertz{950}, .high = Hertz{1'050}};
  EXPECT_NEAR(band_level(steady(clip), clip.rate, around, fourier).count(), -20, 0.05);
}

TEST(CalibrationSound, ThatWouldClipIsRefused) {
  EXPECT_THROW(static_cast<void>(made({.level = Decibels{-3}, .length = 2s})), Error);
  EXPECT_THROW(static_cast<void>(made({.content = Hertz{1'000}, .level = Decibels{-2}})), Error);
  EXPECT_NO_THROW(static_cast<void>(made({.content = Hertz{1'000}, .level = Decibels{-3.1}})));
}

TEST(CalibrationSound, MustFitTheRate) {
  EXPECT_THROW(static_cast<void>(made({.content = Hertz{5'000}, .rate = Hertz{8'000}})), Error);
  EXPECT_THROW(static_cast<void>(made({.content = Band{}, .rate = Hertz{8'000}})), Error);
}

}  // namespace
}  // namespace bimodal::runner
