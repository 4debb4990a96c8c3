#pragma once

#include <string>
#include <vector>

#include "protocols/reading/read_protocol.hpp"
#include "runner/preparation/trial_preparer.hpp"

namespace bimodal::runner {

/// A trial for every word, practice included, in every condition.
[[nodiscard]] std::vector<protocols::PlannedTrial> every_stimulus(
    const protocols::ReadProtocol& read);

/// Puts every trial together, makes its sound and says what is wrong with it: words that cannot be
/// spoken or cut at their gate, sounds that would clip; a warning for those that could with other
/// noise (see highest_peak). `file` names the protocol in the diagnostics.
[[nodiscard]] std::vector<Diagnostic> check_sounds(const protocols::ReadProtocol& read,
                                                   const std::vector<protocols::PlannedTrial>& plan,
                                                   TrialPreparer& preparer,
                                                   const std::string& file);

}  // namespace bimodal::runner
