#pragma once

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

}  // namespace bimodal::runner
