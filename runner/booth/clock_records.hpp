#pragma once

#include "runner/booth/booth.hpp"
#include "runner/store/records.hpp"

namespace bimodal::runner {

/// Adds to `record` how the clocks of display and sound lie on the session clock by now, as far as
/// they are measured.
void note_clocks(const Booth& booth, TrialRecord& record);

}  // namespace bimodal::runner
