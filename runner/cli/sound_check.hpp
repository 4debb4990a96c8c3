#pragma once

#include <string>
#include <vector>

#include "protocols/reading/read_protocol.hpp"
#include "runner/preparation/trial_preparer.hpp"

namespace bimodal::runner {

/// A trial for every word, practice included, in every condition in which it is heard.
[[nodiscard]] std::vector<protocols::PlannedTrial> every_sound(const protocols::ReadProtocol& read);

/// Makes the sound of every trial and says what is wrong with it: words that cannot be spoken,
/// sounds that would clip; a warning for those that could with other noise (see highest_peak).
/// `file` names the protocol in the diagnostics.
[[nodiscard]] std::vector<Diagnostic> check_sounds(const protocols::ReadProtocol& read,
                                                   const std::vector<protocols::PlannedTrial>& plan,
                                                   TrialPreparer& preparer,
                                                   const std::string& file);

}  // namespace bimodal::runner
