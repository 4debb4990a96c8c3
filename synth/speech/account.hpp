#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "stimuli/timeline/account.hpp"
#include "synth/speech/claimant.hpp"
#include "synth/speech/movement.hpp"

namespace bimodal::synth {

inline constexpr std::size_t kMostContacts = 4;

/// The movement of each control whose claims are given. Claims name their segments by index into
/// `claimants`, which the rivals need. Contacts, the rows `contacts` of `claims` (at most
/// kMostContacts; see makes_contact), move by dominance under the rivals, too, but for
/// interpolation: the accounts are of how shapes spread, and would leave lips open in B that must
/// shut under each of them.
[[nodiscard]] std::unique_ptr<const Movement> movement(Account account,
                                                       std::span<const Claimant> claimants,
                                                       const ControlClaims& claims,
                                                       std::span<const std::size_t> contacts);

}  // namespace bimodal::synth
