#include "stimuli/alignment/gaussian_codebook.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bimodal {

namespace {

constexpr std::size_t kDensities = GaussianCodebook::kDensities;
constexpr std::size_t kDimensions = GaussianCodebook::kDimensions;
constexpr float kSmallestVariance = 1e-4F;
/// Densities whose logarithm is that much below the largest one's change no mixture.
constexpr float kNegligible = 9.0F;
/// Of a mixture, so that its logarithm is finite.
constexpr float kSmallestMixture = 1e-30F;

using OneStream = std::array<float, kDensities>;

/// Logarithms of the densities of one stream. The result is local until the end, and the loop over
/// the densities is the inner one, so that it is done several at a time.
OneStream log_densities(const float* x,
                        const float* means,
                        const float* precisions,
                        const float* constants) {
  OneStream sum{};
  std::copy_n(constants, kDensities, sum.begin());
  for (std::size_t i = 0; i < kDimensions; ++i) {
    const float value = x[i];
    for (std::size_t k = 0; k < kDensities; ++k) {
      const float distance = value - means[i * kDensities + k];
      sum[k] -= distance * distance * precisions[i * kDensities + k];
    }
  }
  return sum;
}

}  // namespace

GaussianCodebook::GaussianCodebook(const GaussianTable& means,
                                   const GaussianTable& variances,
                                   std::size_t index)
    : means_(kStreams * kDimensions * kDensities),
      precisions_(means_.size()),
      constants_(kStreams * kDensities) {
  for (std::size_t row = 0; row < kStreams * kDensities; ++row) {
    const std::size_t stream = row / kDensities;
    const std::size_t from = (index * kStreams * kDensities + row) * kDimensions;
    double constant = 0.0;
    for (std::size_t i = 0; i < kDimensions; ++i) {
      const std::size_t to = (stream * kDimensions + i) * kDensities + row % kDensities;
      const float variance = std::max(variances.values[from + i], kSmallestVariance);
      means_[to] = means.values[from + i];
      precisions_[to] = 0.5F / variance;
      constant -= 0.5 * std::log(2.0 * std::numbers::pi * static_cast<double>(variance));
    }
    constants_[row] = static_cast<float>(constant);
  }
}

GaussianCodebook::Densities GaussianCodebook::at(const Cepstra& frame) const {
  Densities made;
  for (std::size_t stream = 0; stream < kStreams; ++stream) {
    const std::size_t tables = stream * kDimensions * kDensities;
    const auto logs = log_densities(&frame.at(stream * kDimensions),
                                    &means_[tables],
                                    &precisions_[tables],
                                    &constants_[stream * kDensities]);
    const float largest = *std::ranges::max_element(logs);
    made.log_largest += largest;
    for (std::size_t k = 0; k < kDensities; ++k) {
      const float relative = logs[k] - largest;
      if (relative > -kNegligible) made.relative[stream * kDensities + k] = std::exp(relative);
    }
  }
  return made;
}

float log_mixture(const GaussianCodebook::Densities& densities, std::span<const float> weights) {
  float sum = densities.log_largest;
  for (std::size_t stream = 0; stream < GaussianCodebook::kStreams; ++stream) {
    const auto* const density = &densities.relative.at(stream * kDensities);
    const auto* const weight = &weights[stream * kDensities];
    std::array<float, 4> part{};  // four sums at a time
    for (std::size_t k = 0; k < kDensities; k += part.size()) {
      for (std::size_t lane = 0; lane < part.size(); ++lane) {
        part[lane] += density[k + lane] * weight[k + lane];
      }
    }
    sum += std::log(kSmallestMixture + (part[0] + part[1]) + (part[2] + part[3]));
  }
  return sum;
}

}  // namespace bimodal
