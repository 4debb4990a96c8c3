#include "synth/speech/dominance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace bimodal::synth {

namespace {

/// Theta, integrated over the way from the peak to `offset_ms`.
double decay(const Dominance& dominance, double offset_ms) {
  const double distance = std::abs(offset_ms);
  const double theta = offset_ms <= 0 ? dominance.theta_before : dominance.theta_after;
  if (offset_ms < 0 && distance > dominance.inflection_ms) {
    return theta * dominance.inflection_ms +
           dominance.theta_early * (distance - dominance.inflection_ms);
  }
  return theta * (dominance.exponent == 1.0 ? distance : std::pow(distance, dominance.exponent));
}

}  // namespace

double Dominance::log_at(Milliseconds offset) const {
  const double x = decay(*this, offset.count());
  const double fall = form == DominanceForm::CriticallyDamped ? std::log1p(x) - x : -x;
  return std::log(alpha) + fall;
}

double Dominance::at(Milliseconds offset) const {
  return std::exp(log_at(offset));
}

double blend(std::span<const Claim> claims, Milliseconds time) {
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
  const auto [lowest, highest] = std::ranges::minmax(claims, {}, &Claim::target);
  return std::clamp(weighted_sum / total_weight, lowest.target, highest.target);  // of rounding
}

}  // namespace bimodal::synth
