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

std::vector<SessionStep> steps_left(const std::vector<SessionStep>& steps,
                                    const std::set<std::size_t>& done,
                                    const std::string& greeting) {
  if (done.empty()) return steps;
  std::vector<SessionStep> left;
  std::vector<SessionStep> pages;  // since the last trial
  bool begun = false;
  for (const auto& step : steps) {
    const auto* const trial = std::get_if<TrialStep>(&step);
    if (trial == nullptr) {
      pages.push_back(step);
      continue;
    }
    if (!done.contains(trial->trial)) {
      if (begun) {
        left.insert(left.end(), pages.begin(), pages.end());
      } else {
        left.emplace_back(PageStep{.text = greeting, .progress = trial->progress});
      }
      begun = true;
      left.push_back(step);
    }
    pages.clear();
  }
  left.insert(left.end(), pages.begin(), pages.end());
  return left;
}

}  // namespace bimodal::runner
