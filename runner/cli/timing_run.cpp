#include "runner/cli/timing_run.hpp"

#include <algorithm>

#include "runner/booth/trial_presentation.hpp"
#include "stimuli/base/random.hpp"

namespace bimodal::runner {

namespace {

std::optional<Duration> reported(const TrialRecord& record, std::string_view modality) {
  const auto found = std::ranges::find(record.onsets, modality, &OnsetRecord::modality);
  return found == record.onsets.end() ? std::nullopt : found->reported;
}

bool asks_to_stop_now(const Booth& booth) {
  return std::ranges::any_of(booth.keyboard.poll(), asks_to_stop);
}

}  // namespace

std::vector<TimedTrial> run_timing(const Booth& booth,
                                   const TimingPlan& plan,
                                   const std::function<void(int, TimedTrial&)>& after,
                                   const std::function<bool()>& stopped) {
  const auto flash = make_flash_trial(plan.flash);
  Random random{plan.seed};
  const protocols::Triggers none;
  TriggerLog triggers{none, booth.trigger_lines};
  std::vector<TimedTrial> trials;
  trials.reserve(static_cast<std::size_t>(plan.trials));
  for (int index = 0; index < plan.trials && !stopped(); ++index) {
    const auto span = plan.longest_fixation - plan.shortest_fixation;
    const auto fixation =
        plan.shortest_fixation +
        Duration{static_cast<std::int64_t>(random.uniform() * static_cast<double>(span.count()))};
    TrialMachine machine{{.fixation = fixation, .time_limit = {}}};
    TimedTrial timed;
    timed.record.trial = index;
    static_cast<void>(present_trial(booth, flash, machine, triggers, timed.record));
    timed.visual = reported(timed.record, "visual");
    timed.auditory = reported(timed.record, "auditory");
    after(index, timed);
    trials.push_back(std::move(timed));
    if (machine.phase() == TrialMachine::Phase::Confirming || asks_to_stop_now(booth)) break;
  }
  return trials;
}

}  // namespace bimodal::runner
