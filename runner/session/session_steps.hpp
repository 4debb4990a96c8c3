#pragma once

#include <set>
#include <string>
#include <variant>
#include <vector>

#include "protocols/design/plan.hpp"
#include "protocols/model/protocol.hpp"

namespace bimodal::runner {

/// A page of text that waits for Enter.
struct PageStep {
  std::string text;
  bool is_break = false;
  double progress = 0.0;  ///< part of the main trials done, 0 to 1
};

struct TrialStep {
  std::size_t trial = 0;  ///< index into the plan
  double progress = 0.0;
};

using SessionStep = std::variant<PageStep, TrialStep>;

/// Everything that a participant meets, in order: instructions, practice, the announcement that the
/// main part begins, trials with breaks, farewell.
[[nodiscard]] std::vector<SessionStep> session_steps(
    const protocols::Protocol& protocol, const std::vector<protocols::PlannedTrial>& plan);

/// What is left of a session that was cut off when the trials of `done` (indices into the plan)
/// were stored: the steps from the first other trial on, without trials that are done and pages
/// that lead to none, after a page of `greeting`. Of a session that is done nothing but what
/// follows its last trial.
[[nodiscard]] std::vector<SessionStep> steps_left(const std::vector<SessionStep>& steps,
                                                  const std::set<std::size_t>& done,
                                                  const std::string& greeting);

}  // namespace bimodal::runner
