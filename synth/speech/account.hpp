#pragma once

#include <memory>
#include <span>

#include "stimuli/timeline/account.hpp"
#include "synth/speech/claimant.hpp"
#include "synth/speech/movement.hpp"

namespace bimodal::synth {

/// The movement of each control whose claims are given. Claims name their segments by index into
/// `claimants`, which the rivals need.
[[nodiscard]] std::unique_ptr<const Movement> movement(Account account,
                                                       std::span<const Claimant> claimants,
                                                       const ControlClaims& claims);

}  // namespace bimodal::synth
