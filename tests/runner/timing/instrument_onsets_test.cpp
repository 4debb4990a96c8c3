#include "runner/timing/instrument_onsets.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal::runner {
namespace {

std::vector<float> noise(std::size_t count, double size, Random& random) {
  std::vector<float> samples(count);
  for (auto& sample : samples) sample = static_cast<float>(size * (2.0 * random.uniform() - 1.0));
  return samples;
}

TEST(OnsetOfLight, LiesHalfWayUpARamp) {
  // Rest 0.1, then from sample 100 on 0.1 a sample up to 0.9: half-way, 0.5, is sample 104.
  std::vector<float> signal(300, 0.1F);
  for (std::size_t i = 100; i < signal.size(); ++i) {
    signal[i] = std::min(0.9F, 0.1F + 0.1F * static_cast<float>(i - 100));
  }
  EXPECT_NEAR(onset_of_light(signal, 50, 20).value(), 104.0, 1e-3);
  for (auto& sample : signal) sample = -sample;
  EXPECT_NEAR(onset_of_light(signal, 50, 20).value(), 104.0, 1e-3);
}

TEST(OnsetOfLight, IsFoundInNoiseWhateverItsPlaceAndDirection) {
  Random random{5};
  for (int round = 0; round < 300; ++round) {
    auto signal = noise(2000, 0.01, random);
    const auto at = 400 + random.below(1000);
    const float step =
        (random.below(2) == 0 ? 1.0F : -1.0F) * (0.2F + static_cast<float>(random.uniform()));
    for (std::size_t i = at; i < signal.size(); ++i) signal[i] += step;
    const auto found = onset_of_light(signal, 300, 50);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, static_cast<double>(at) - 0.5, 0.5);
  }
}

TEST(OnsetOfLight, IsNotAFlickerShorterThanItMustLast) {
  std::vector<float> signal(600, 0.0F);
  for (std::size_t i = 200; i < 210; ++i) signal[i] = 1.0F;
  for (std::size_t i = 400; i < 600; ++i) signal[i] = 1.0F;
  EXPECT_NEAR(onset_of_light(signal, 100, 50).value(), 399.5, 1e-6);
}

TEST(OnsetOfLight, IsAbsentWithoutAStep) {
  Random random{6};
  EXPECT_FALSE(onset_of_light(noise(2000, 0.01, random), 300, 50));
  EXPECT_FALSE(onset_of_light(std::vector<float>(2000, 0.3F), 300, 50));
  EXPECT_FALSE(onset_of_light(std::vector<float>(10, 0.3F), 300, 50));
}

TEST(OnsetOfSound, IsTheFirstLoudSample) {
  Random random{7};
  for (int round = 0; round < 300; ++round) {
    auto signal = noise(3000, 0.002, random);
    const auto at = 700 + random.below(1000);
    for (std::size_t i = at; i < at + 1000; ++i) {
      signal[i] += 0.25F * static_cast<float>(
                               std::cos(std::numbers::pi * static_cast<double>(i - at) / 24.0));
    }
    EXPECT_EQ(onset_of_sound(signal, 500).value(), static_cast<double>(at));
  }
}

TEST(OnsetOfSound, IsAbsentInSilence) {
  Random random{8};
  EXPECT_FALSE(onset_of_sound(noise(2000, 0.01, random), 300));
  EXPECT_FALSE(onset_of_sound(std::vector<float>(2000, 0.0F), 300));
}

}  // namespace
}  // namespace bimodal::runner
