#include "stimuli/timeline/account.hpp"

#include <algorithm>
#include <array>

namespace bimodal {

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

std::span<const AccountDescription> accounts() {
  return kAccounts;
}

std::string_view name(Account account) {
  return kAccounts.at(static_cast<std::size_t>(account)).name;
}

std::optional<Account> account_from_name(std::string_view name) {
  const auto* const found = std::ranges::find(kAccounts, name, &AccountDescription::name);
  if (found == kAccounts.end()) return std::nullopt;
  return found->account;
}

}  // namespace bimodal
