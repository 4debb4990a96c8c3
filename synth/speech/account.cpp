#include "synth/speech/account.hpp"

#include <algorithm>

#include "synth/speech/dominance_movement.hpp"
#include "synth/speech/rival_movements.hpp"

namespace bimodal::synth {

double claiming_threshold(const std::vector<Claim>& claims) {
  double greatest = 0;
  for (const auto& claim : claims) greatest = std::max(greatest, claim.dominance.alpha);
  return kClaimingAlpha * greatest;
}

std::unique_ptr<const Movement> movement(Account account,
                                         std::span<const Claimant> claimants,
                                         const ControlClaims& claims) {
  switch (account) {
    case Account::Dominance:
      return std::make_unique<DominanceMovement>(claims);
    case Account::Interpolation:
      return interpolation(claims);
    case Account::LookAhead:
      return look_ahead(claimants, claims);
    case Account::TimeLocked:
      return time_locked(claimants, claims);
    case Account::Hybrid:
      return hybrid(claimants, claims);
  }
  return nullptr;
}

}  // namespace bimodal::synth
