#include "synth/fitting/part_dynamics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace bimodal::synth {

namespace {

/// The rate with which a part's dominance falls on the side where the instant lies.
double theta_of(const SpokenPart& part, const PartDynamics& asked, double tau) {
  if (tau >= 0) return part.begins ? 0 : std::exp(asked.log_theta_before);
  return part.ends ? 0 : std::exp(asked.log_theta_after);
}

}  // namespace

double blended(std::span<const SpokenPart> spoken,
               std::span<const PartDynamics> asked,
               double time_ms) {
  std::vector<PartDynamics> ignored(spoken.size());
  return blend_gradient(spoken, asked, time_ms, ignored);
}

double blend_gradient(std::span<const SpokenPart> spoken,
                      std::span<const PartDynamics> asked,
                      double time_ms,
                      std::span<PartDynamics> gradient) {
  assert(!spoken.empty() && asked.size() == spoken.size() && gradient.size() == spoken.size());
  const auto log_dominance = [&](std::size_t i) {
    const double tau = spoken[i].centre_ms + asked[i].offset_ms - time_ms;
    return asked[i].log_alpha - theta_of(spoken[i], asked[i], tau) * std::abs(tau);
  };
  // Divided by the largest first, so that the weights mean something far from every peak.
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < spoken.size(); ++i) largest = std::max(largest, log_dominance(i));
  double total = 0;
  double weighted = 0;
  for (std::size_t i = 0; i < spoken.size(); ++i) {
    const double weight = std::exp(log_dominance(i) - largest);
    gradient[i] = {.target = weight};
    total += weight;
    weighted += weight * asked[i].target;
  }
  const double value = weighted / total;
  for (std::size_t i = 0; i < spoken.size(); ++i) {
    auto& slope = gradient[i];
    slope.target /= total;
    slope.log_alpha = slope.target * (asked[i].target - value);
    const double tau = spoken[i].centre_ms + asked[i].offset_ms - time_ms;
    const double theta = theta_of(spoken[i], asked[i], tau);
    const double by_log_theta = -theta * std::abs(tau) * slope.log_alpha;
    (tau >= 0 ? slope.log_theta_before : slope.log_theta_after) = by_log_theta;
    slope.offset_ms = (tau >= 0 ? -theta : theta) * slope.log_alpha;
  }
  return value;
}

}  // namespace bimodal::synth
