#include "protocols/observers/observer_description.hpp"

#include <cassert>
#include <cmath>

namespace bimodal::protocols {

namespace {

PhoneTable heard(const ObserverDescription& description, std::optional<Decibels> snr) {
  if (!snr.has_value()) return identity_confusions();
  const double above = snr->count() - description.stated_snr.count();
  const double weight = std::tanh(description.slope_per_db * std::abs(above) / 2.0);
  return mixture(
      description.auditory, above > 0.0 ? identity_confusions() : uniform_confusions(), weight);
}

}  // namespace

PhoneTable confusions(const ObserverDescription& description, const Presented& presented) {
  assert(description.slope_per_db > 0.0);
  if (!presented.heard) return presented.seen ? description.visual : uniform_confusions();
  const PhoneTable auditory = heard(description, presented.snr);
  return presented.seen ? fuzzy_product(auditory, description.visual) : auditory;
}

}  // namespace bimodal::protocols
