#pragma once

#include <functional>
#include <vector>

#include "runner/booth/booth.hpp"
#include "runner/booth/trigger_log.hpp"
#include "runner/preparation/trial_preparer.hpp"
#include "runner/session/cue_sheet.hpp"
#include "runner/session/trial_machine.hpp"
#include "runner/store/records.hpp"

namespace bimodal::runner {

/// From the fixation mark to the end of everything seen and heard: chooses the first refresh ahead,
/// presents the stimulus and writes down in `record` what happened. The screen is drawn at every
/// refresh, for one that rests may change its rhythm. Returns what the machine asks for at the end:
/// the answer may have been given already.
/// Sessions and `bimodal timing` present by this one function. `begins` is called once, under the
/// fixation mark, just before the stimulus is planned; it must return within a millisecond.
std::vector<TrialCommand> present_trial(const Booth& booth,
                                        const PreparedTrial& trial,
                                        TrialMachine& machine,
                                        TriggerLog& triggers,
                                        TrialRecord& record,
                                        const std::function<void()>& begins = {});

}  // namespace bimodal::runner
