#include "protocols/observers/closed_set.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace bimodal::protocols {

namespace {

constexpr double kLeast = 1e-6;

bool same_shape(const Pronunciation& one, const Pronunciation& other) {
  return std::ranges::equal(one, other, same_kind);
}

double weight(const Pronunciation& stimulus,
              const Pronunciation& option,
              const PhoneTable& confusions) {
  double product = 1.0;
  for (std::size_t i = 0; i < stimulus.size(); ++i) {
    product *= std::max(confusions(stimulus[i], option[i]), kLeast);
  }
  return product;
}

}  // namespace

std::vector<double> closed_set_probabilities(const Pronunciation& stimulus,
                                             std::span<const Pronunciation> options,
                                             const PhoneTable& confusions) {
  assert(!options.empty());
  std::vector<double> weights;
  weights.reserve(options.size());
  for (const auto& option : options) {
    weights.push_back(same_shape(stimulus, option) ? weight(stimulus, option, confusions) : 0.0);
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (sum <= 0.0) {
    return std::vector<double>(options.size(), 1.0 / static_cast<double>(options.size()));
  }
  for (double& each : weights) each /= sum;
  return weights;
}

}  // namespace bimodal::protocols
