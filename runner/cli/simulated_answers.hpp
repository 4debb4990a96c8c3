#pragma once

#include <functional>
#include <string>

#include "protocols/design/plan.hpp"
#include "protocols/model/protocol.hpp"

namespace bimodal::runner {

using Answers = std::function<std::string(const protocols::PlannedTrial&)>;

/// The answers of the project's typical simulated observer to the trials of one session; `seed`
/// decides them, other sessions have independent ones. `protocol` is borrowed.
[[nodiscard]] Answers simulated_answers(const protocols::Protocol& protocol,
                                        const protocols::SessionKey& key,
                                        Seed seed);

/// What is stored as the session's observer.
[[nodiscard]] std::string observer_name();

}  // namespace bimodal::runner
