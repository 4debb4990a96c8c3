#include "synth/speech/dominance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace bimodal::synth {

namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;

}  // namespace

double Dominance::log_at(Duration offset) const {
  const double theta = offset <= Duration::zero() ? theta_before : theta_after;
  const double distance = std::abs(Milliseconds{offset}.count());
  const double powered = exponent == 1.0 ? distance : std::pow(distance, exponent);
  return std::log(alpha) - theta * powered;
}

double Dominance::at(Duration offset) const {
  return std::exp(log_at(offset));
}

double blend(std::span<const Claim> claims, Duration time) {
  assert(!claims.empty());

  // Far from every peak all dominances underflow to zero together; dividing them by the largest
  // first keeps the weights meaningful at any distance.
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto& claim : claims) {
    largest = std::max(largest, claim.dominance.log_at(time - claim.peak));
  }

  double weighted_sum = 0.0;
  double total_weight = 0.0;
  for (const auto& claim : claims) {
    const double weight = std::exp(claim.dominance.log_at(time - claim.peak) - largest);
    weighted_sum += weight * claim.target;
    total_weight += weight;
  }
  return weighted_sum / total_weight;
}

}  // namespace bimodal::synth
