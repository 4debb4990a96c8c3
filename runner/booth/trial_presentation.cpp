#include "runner/booth/trial_presentation.hpp"

#include <algorithm>
#include <variant>

#include "runner/booth/stimulus_presentation.hpp"

namespace bimodal::runner {

namespace {

/// From scheduling to the first refresh at the earliest, whatever the sound needs.
constexpr Duration kSchedulingMargin = std::chrono::milliseconds{50};

}  // namespace

std::vector<TrialCommand> present_trial(const Booth& booth,
                                        const PreparedTrial& trial,
                                        TrialMachine& machine,
                                        TriggerLog& triggers,
                                        TrialRecord& record,
                                        const std::function<void()>& begins) {
  Screen fixation;
  fixation.fixation = true;
  const auto shown = booth.display.present(fixation, booth.clock.now());
  triggers.send(protocols::TriggerEvent::TrialStart, shown.onset);
  const auto commands = machine.on(FixationShown{shown.onset});
  const auto earliest = std::get<StartStimulus>(commands.at(0)).earliest;
  const auto sound_ahead = trial.layout.has_sound ? booth.audio.lead_time() : Duration{};
  do {
    for (const auto& stroke : booth.keyboard.poll()) static_cast<void>(machine.on(stroke));
    static_cast<void>(booth.display.present(fixation, booth.clock.now()));
  } while (booth.clock.now() + kSchedulingMargin + sound_ahead < earliest);
  if (begins) begins();
  const auto now = booth.clock.now();
  CueSheet cues{
      trial.layout,
      trial.drawing_rate,
      booth.display.refresh(),
      std::max(earliest, now + kSchedulingMargin),
      now + booth.audio.lead_time() + booth.reference.sound_after - booth.reference.line_after};
  present_stimulus(booth, trial, cues, machine, triggers, record);
  return machine.on(StimulusEnded{cues.end()});
}

}  // namespace bimodal::runner
