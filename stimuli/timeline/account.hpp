#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace bimodal {

/// Accounts of coarticulation: how neighbouring segments shape each other. What tells the rivals
/// apart is when the lips begin to round in /i C u/ as consonants grow longer (Perkell 1989; figure
/// 1 of Cohen & Massaro 1993): look-ahead begins as soon as the first vowel ends, so that the lead
/// over the second grows with the consonants (slope 1); time-locked begins a fixed time ahead
/// (slope 0); hybrid does both, gently first and then fast.
enum class Account : std::uint8_t {
  Dominance,      ///< Cohen & Massaro (1993): targets weighted by dominance
  Interpolation,  ///< none: straight lines from target to target
  LookAhead,      ///< Kapoor, Goyal & Kalra (2000): vowels reach into what is more deformable
  TimeLocked,     ///< coproduction (Bell-Berti & Harris 1981): gestures of a fixed extent
  Hybrid,         ///< two phases (Bladon & Al-Bamerni 1982; Perkell & Chiang 1986)
};

struct AccountDescription {
  Account account;
  std::string_view name;  ///< in files and on the command line: "look-ahead"
  std::string_view meaning;
};

/// One row per account, in the order of the enumeration.
[[nodiscard]] std::span<const AccountDescription> accounts();

[[nodiscard]] std::string_view name(Account account);

[[nodiscard]] std::optional<Account> account_from_name(std::string_view name);

}  // namespace bimodal
