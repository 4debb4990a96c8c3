#pragma once

#include <functional>
#include <string>

#include "protocols/design/plan.hpp"
#include "protocols/model/protocol.hpp"

namespace bimodal::runner {

using Answers = std::function<std::string(const protocols::PlannedTrial&)>;

/// The answers of the project's typical simulated observer to one participant's trials; `seed`
/// decides them. `protocol` is borrowed.
[[nodiscard]] Answers simulated_answers(const protocols::Protocol& protocol,
                                        int participant_number,
                                        Seed seed);

/// What is stored as the session's observer.
[[nodiscard]] std::string observer_name();

}  // namespace bimodal::runner
