#pragma once

#include "runner/booth/booth.hpp"
#include "runner/booth/trigger_log.hpp"
#include "runner/preparation/trial_preparer.hpp"
#include "runner/session/cue_sheet.hpp"
#include "runner/session/trial_machine.hpp"
#include "runner/store/records.hpp"

namespace bimodal::runner {

/// Shows and plays a prepared trial as its cue sheet says, and writes down in `record` what was
/// shown and heard, when, and by whose word. Keystrokes go to `machine`, what other equipment is to
/// know to `triggers`. Returns when everything has been heard and seen. Throws SoundLost if the
/// sound device is. In the loop nothing is allocated but what keystrokes need.
///
/// Until the sound must be handed over for good, picture and sound follow the screen's refreshes;
/// from then on the frame of each refresh is the one that is due by the session clock, so that the
/// picture keeps to the sound whatever the screen does. `cues` is left as it was carried out.
void present_stimulus(const Booth& booth,
                      const PreparedTrial& trial,
                      CueSheet& cues,
                      TrialMachine& machine,
                      TriggerLog& triggers,
                      TrialRecord& record);

/// Once the answer is there: waits until everything is known of the trial's sound, which is the
/// case some buffers after its end, and flags the trial if the sound's clock jumped in those.
void review_sound(const Booth& booth, TrialRecord& record);

}  // namespace bimodal::runner
