#include "stimuli/audio/resample.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"
#include "tests/stimuli/audio/signals.hpp"

namespace bimodal {
namespace {

using testing_signals::largest_difference;
using testing_signals::sine;

TEST(Resample, HasTheNearestNumberOfSamples) {
  Random random{1};
  for (int i = 0; i < 200; ++i) {
    const double from = 8000.0 + static_cast<double>(random.below(90'000));
    const double to = 8000.0 + static_cast<double>(random.below(90'000));
    const auto samples = 1 + random.below(2000);
    const Clip sound{Hertz{from}, std::vector<float>(samples, 0.1F)};
    const auto made = resample(sound, Hertz{to});
    EXPECT_EQ(made.rate, Hertz{to});
    ASSERT_EQ(made.samples.size(),
              static_cast<std::size_t>(std::floor(static_cast<double>(samples) * to / from + 0.5)))
        << samples << " from " << from << " to " << to;
  }
}

TEST(Resample, KeepsASineInPlaceAndSize) {
  for (const double to : {8000.0, 22'050.0, 44'100.0, 48'000.0, 96'000.0}) {
    for (const double frequency : {100.0, 997.0, 3000.0}) {
      const Clip sound{Hertz{16'000}, sine(16'000, 16'000, frequency, 0.5)};
      const auto made = resample(sound, Hertz{to});
      const auto expected = sine(made.samples.size(), to, frequency, 0.5);
      const auto quarter = made.samples.size() / 4;  // away from the edges' transients
      EXPECT_LT(largest_difference(std::span{made.samples}.subspan(quarter, 2 * quarter),
                                   std::span{expected}.subspan(quarter, 2 * quarter)),
                2e-6)
          << frequency << " Hz to " << to;
    }
  }
}

TEST(Resample, KeepsAClickAtItsInstant) {
  Clip click{Hertz{16'000}, std::vector<float>(1000)};
  click.samples[400] = 1.0F;
  const auto made = resample(click, Hertz{48'000}).samples;
  const auto top = std::ranges::max_element(made) - made.begin();
  EXPECT_EQ(top, 1200);
  EXPECT_NEAR(made[1199], made[1201], 1e-5F);  // symmetrical: linear phase
}

TEST(Resample, RemovesWhatTheLowerRateCannotHold) {
  const Clip sound{Hertz{48'000}, sine(48'000, 48'000, 10'000, 0.5)};
  const auto made = resample(sound, Hertz{16'000}).samples;
  EXPECT_LT(testing_signals::rms(std::span{made}.subspan(4000, 8000)), 1e-6);
}

TEST(Resample, ReturnsTheVerySamplesAtAnEqualRate) {
  const Clip sound{Hertz{44'100}, testing_signals::repeatable(777)};
  EXPECT_EQ(resample(sound, Hertz{44'100}).samples, sound.samples);
}

TEST(Resample, GivesTheSameSamplesEveryTime) {
  const Clip sound{Hertz{16'000}, testing_signals::repeatable(7000)};
  EXPECT_EQ(resample(sound, Hertz{44'100}).samples, resample(sound, Hertz{44'100}).samples);
}

TEST(Resample, RefusesRatesThatAreNone) {
  EXPECT_THROW((void)resample({Hertz{16'000}, {0.0F}}, Hertz{0}), Error);
  EXPECT_THROW((void)resample({Hertz{0}, {0.0F}}, Hertz{16'000}), Error);
  EXPECT_THROW((void)resample({Hertz{-1}, {0.0F}}, Hertz{16'000}), Error);
  EXPECT_THROW((void)resample({Hertz{1}, {0.0F}}, Hertz{16'000}), Error);
}

}  // namespace
}  // namespace bimodal
