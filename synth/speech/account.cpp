#include "synth/speech/account.hpp"

#include <algorithm>
#include <array>

#include "synth/speech/dominance_movement.hpp"
#include "synth/speech/rival_movements.hpp"

namespace bimodal::synth {

namespace {

constexpr std::array<AccountDescription, 5> kAccounts{{
    {Account::Dominance, "dominance", "targets weighted by dominance (Cohen & Massaro 1993)"},
    {Account::Interpolation, "none", "straight lines from target to target"},
    {Account::LookAhead,
     "look-ahead",
     "vowels reach into more deformable consonants (Pelachaud 1991; Kapoor et al. 2000)"},
    {Account::TimeLocked,
     "time-locked",
     "gestures of a fixed extent around each sound (coproduction: Bell-Berti & Harris 1981)"},
    {Account::Hybrid,
     "hybrid",
     "a slow phase from the earliest moment, a fast one a fixed time ahead (Perkell & Chiang "
     "1986)"},
}};

}  // namespace

double claiming_threshold(const std::vector<Claim>& claims) {
  double greatest = 0;
  for (const auto& claim : claims) greatest = std::max(greatest, claim.dominance.alpha);
  return kClaimingAlpha * greatest;
}

std::span<const AccountDescription> accounts() {
  return kAccounts;
}

std::optional<Account> account_from_name(std::string_view name) {
  const auto* const found = std::ranges::find(kAccounts, name, &AccountDescription::name);
  if (found == kAccounts.end()) return std::nullopt;
  return found->account;
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
