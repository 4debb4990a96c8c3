#include "stimuli/alignment/gaussian_codebook.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal {
namespace {

constexpr auto kStreams = GaussianCodebook::kStreams;
constexpr auto kDensities = GaussianCodebook::kDensities;
constexpr auto kDimensions = GaussianCodebook::kDimensions;

GaussianTable table(std::size_t codebooks, Random& random, double low, double high) {
  GaussianTable made{codebooks, kStreams, kDensities, kDimensions, {}};
  for (std::size_t i = 0; i < codebooks * kStreams * kDensities * kDimensions; ++i) {
    made.values.push_back(static_cast<float>(low + (high - low) * random.uniform()));
  }
  return made;
}

/// The textbook's formula, one number at a time.
double expected(const GaussianTable& means,
                const GaussianTable& variances,
                std::size_t codebook,
                const Cepstra& frame,
                const std::vector<float>& weights) {
  double log_product = 0.0;
  for (std::size_t stream = 0; stream < kStreams; ++stream) {
    double mixture = 0.0;
    for (std::size_t k = 0; k < kDensities; ++k) {
      double density = 1.0;
      for (std::size_t i = 0; i < kDimensions; ++i) {
        const auto at = ((codebook * kStreams + stream) * kDensities + k) * kDimensions + i;
        const double variance = static_cast<double>(variances.values.at(at));
        const double off = static_cast<double>(frame.at(stream * kDimensions + i)) -
                           static_cast<double>(means.values.at(at));
        density *=
            std::exp(-off * off / (2.0 * variance)) / std::sqrt(2.0 * std::numbers::pi * variance);
      }
      mixture += density * static_cast<double>(weights.at(stream * kDensities + k));
    }
    log_product += std::log(mixture);
  }
  return log_product;
}

TEST(GaussianCodebook, GivesTheLikelihoodOfATextbookMixture) {
  Random random{3};
  const auto means = table(2, random, -1.0, 1.0);
  const auto variances = table(2, random, 0.5, 3.0);
  const GaussianCodebook codebook{means, variances, 1};
  for (int repeat = 0; repeat < 20; ++repeat) {
    Cepstra frame{};
    for (float& value : frame) value = static_cast<float>(random.normal());
    std::vector<float> weights;
    for (std::size_t i = 0; i < kStreams * kDensities; ++i) {
      weights.push_back(static_cast<float>(random.uniform() / kDensities));
    }
    EXPECT_NEAR(static_cast<double>(log_mixture(codebook.at(frame), weights)),
                expected(means, variances, 1, frame, weights),
                0.01);
  }
}

TEST(GaussianCodebook, StaysFiniteFarFromEveryDensity) {
  Random random{4};
  const GaussianCodebook codebook{table(1, random, -1.0, 1.0), table(1, random, 0.01, 0.02), 0};
  Cepstra frame{};
  frame.fill(1000.0F);
  const std::vector<float> weights(kStreams * kDensities);
  EXPECT_TRUE(std::isfinite(log_mixture(codebook.at(frame), weights)));
}

}  // namespace
}  // namespace bimodal
