#pragma once

#include <string>
#include <vector>

#include "protocols/reading/read_protocol.hpp"
#include "runner/preparation/trial_preparer.hpp"

namespace bimodal::runner {

/// Makes the sound of every trial of a plan and says what is wrong with it: words that cannot be
/// spoken, sounds that would clip. `file` names the protocol in the diagnostics.
[[nodiscard]] std::vector<Diagnostic> check_sounds(const protocols::Protocol& protocol,
                                                   const std::vector<protocols::PlannedTrial>& plan,
                                                   TrialPreparer& preparer,
                                                   const std::string& file);

}  // namespace bimodal::runner
