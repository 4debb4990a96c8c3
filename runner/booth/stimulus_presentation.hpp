#pragma once

#include "runner/booth/booth.hpp"
#include "runner/booth/trigger_log.hpp"
#include "runner/preparation/trial_preparer.hpp"
#include "runner/session/cue_sheet.hpp"
#include "runner/session/trial_machine.hpp"
#include "runner/store/records.hpp"

namespace bimodal::runner {

/// Shows and plays a prepared trial as its cue sheet says, and writes down in `record` what was
/// shown and heard, when, and by whose word. Keystrokes go to `machine`, what
/// other equipment is to know to `triggers`. Returns when everything
/// has ended. In the loop nothing is allocated but what keystrokes need.
void present_stimulus(const Booth& booth,
                      const PreparedTrial& trial,
                      const CueSheet& cues,
                      TrialMachine& machine,
                      TriggerLog& triggers,
                      TrialRecord& record);

}  // namespace bimodal::runner
