#include "runner/session/session_steps.hpp"

#include <algorithm>

namespace bimodal::runner {

std::vector<SessionStep> session_steps(const protocols::Protocol& protocol,
                                       const std::vector<protocols::PlannedTrial>& plan) {
  using protocols::Phase;
  using protocols::PlannedTrial;
  const auto main_trials = std::ranges::count(plan, Phase::Main, &PlannedTrial::phase);
  const auto progress = [&](std::ptrdiff_t done) {
    return main_trials == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(main_trials);
  };

  std::vector<SessionStep> steps;
  for (const auto& page : protocol.instructions) steps.emplace_back(PageStep{.text = page});
  std::ptrdiff_t done = 0;
  const PlannedTrial* previous = nullptr;
  for (const auto& trial : plan) {
    if (previous != nullptr && previous->phase != trial.phase) {
      steps.emplace_back(PageStep{.text = "The practice is over.\nNow the experiment begins."});
    } else if (previous != nullptr && previous->block != trial.block) {
      steps.emplace_back(
          PageStep{.text = protocol.breaks.text, .is_break = true, .progress = progress(done)});
    }
    steps.emplace_back(TrialStep{.trial = trial.index, .progress = progress(done)});
    if (trial.phase == Phase::Main) ++done;
    previous = &trial;
  }
  if (!protocol.farewell.empty()) {
    steps.emplace_back(PageStep{.text = protocol.farewell, .progress = 1.0});
  }
  return steps;
}

}  // namespace bimodal::runner
