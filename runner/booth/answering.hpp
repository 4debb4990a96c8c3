#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "protocols/model/protocol.hpp"
#include "runner/booth/booth.hpp"
#include "runner/booth/oversight.hpp"
#include "runner/booth/trigger_log.hpp"
#include "runner/session/option_grid.hpp"
#include "runner/session/trial_machine.hpp"
#include "runner/store/records.hpp"

namespace bimodal::runner {

/// Everything but the answer itself.
struct Question {
  const protocols::Response& response;
  OptionGrid grid;               ///< of a choice
  std::uint32_t background = 0;  ///< of the window, 0xRRGGBB
};

[[nodiscard]] Question question_of(const protocols::Protocol& protocol);

/// What answers trials of this protocol.
[[nodiscard]] TrialRules trial_rules(const protocols::Protocol& protocol, const Question& question);

/// After the stimulus: shows the question, anew whenever it changes, with `progress` (part of the
/// main trials done) below it, until the answer is there, and writes it and its keystrokes down in
/// `record`. `at_end`: what the machine asked for when the stimulus ended; the answer may be in it.
/// False if the session is to be stopped; the trial is then not answered.
[[nodiscard]] bool collect_answer(const Booth& booth,
                                  Oversight& oversight,
                                  const Question& question,
                                  double progress,
                                  TrialMachine& machine,
                                  const std::vector<TrialCommand>& at_end,
                                  TrialRecord& record);

/// After the answer: tells other equipment of it, if it came after the stimulus, and waits until
/// all lines have reported what became of the trial's signals (0.3 s at most), which go into
/// `record`.
void finish_triggers(const Booth& booth,
                     const TrialMachine& machine,
                     TriggerLog& triggers,
                     TrialRecord& record);

/// How long ago a stroke ended the answer; absent where time did, or where it came during the
/// stimulus.
[[nodiscard]] std::optional<Duration> since_last_stroke(const Booth& booth,
                                                        const TrialMachine& machine,
                                                        const TrialRecord& record);

}  // namespace bimodal::runner
