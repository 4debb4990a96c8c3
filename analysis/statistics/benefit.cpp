#include "analysis/statistics/benefit.hpp"

#include <cmath>

namespace bimodal::analysis {

namespace {

std::optional<double> of_what_is_left(double reached, double from) {
  if (from >= 1.0) return std::nullopt;
  return (reached - from) / (1.0 - from);
}

std::optional<double> logit(double proportion) {
  if (proportion <= 0.0 || proportion >= 1.0) return std::nullopt;
  return std::log(proportion / (1.0 - proportion));
}

}  // namespace

Benefit benefit(double bimodal, double auditory, std::optional<double> visual) {
  Benefit found{.gain = bimodal - auditory, .relative = of_what_is_left(bimodal, auditory)};
  const auto logit_bimodal = logit(bimodal);
  const auto logit_auditory = logit(auditory);
  if (logit_bimodal && logit_auditory) found.log_odds = *logit_bimodal - *logit_auditory;
  if (visual) {
    found.auditory_relative = of_what_is_left(bimodal, *visual);
    found.excess = bimodal - (auditory + *visual - auditory * *visual);
  }
  return found;
}

std::optional<double> share_of_natural_benefit(double synthetic, double natural, double auditory) {
  if (natural <= auditory) return std::nullopt;
  return (synthetic - auditory) / (natural - auditory);
}

}  // namespace bimodal::analysis
