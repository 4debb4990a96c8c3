#include "synth/speech/account.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>
#include <vector>

#include "synth/speech/dominance_movement.hpp"
#include "synth/speech/rival_movements.hpp"

namespace bimodal::synth {

double claiming_threshold(const std::vector<Claim>& claims) {
  double greatest = 0;
  for (const auto& claim : claims) greatest = std::max(greatest, claim.dominance.alpha);
  return kClaimingAlpha * greatest;
}

namespace {

/// Some rows by dominance, the others by another account.
class WithContacts final : public Movement {
 public:
  WithContacts(std::unique_ptr<const Movement> others,
               const ControlClaims& claims,
               std::span<const std::size_t> contacts)
      : others_{std::move(others)},
        rows_{contacts.begin(), contacts.end()},
        contacts_{chosen(claims, contacts)} {
    assert(contacts.size() <= kMostContacts);
  }

  void at(Milliseconds time, std::span<double> values) const override {
    others_->at(time, values);
    std::array<double, kMostContacts> contact{};
    contacts_.at(time, std::span{contact}.first(rows_.size()));
    for (std::size_t i = 0; i < rows_.size(); ++i) values[rows_[i]] = contact[i];
  }

 private:
  static ControlClaims chosen(const ControlClaims& claims, std::span<const std::size_t> contacts) {
    ControlClaims rows;
    for (const auto row : contacts) rows.push_back(claims[row]);
    return rows;
  }

  std::unique_ptr<const Movement> others_;
  std::vector<std::size_t> rows_;
  DominanceMovement contacts_;
};

std::unique_ptr<const Movement> by_account(Account account,
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

}  // namespace

std::unique_ptr<const Movement> movement(Account account,
                                         std::span<const Claimant> claimants,
                                         const ControlClaims& claims,
                                         std::span<const std::size_t> contacts) {
  auto made = by_account(account, claimants, claims);
  const bool is_rival = account != Account::Dominance && account != Account::Interpolation;
  if (!is_rival || contacts.empty()) return made;
  return std::make_unique<WithContacts>(std::move(made), claims, contacts);
}

}  // namespace bimodal::synth
