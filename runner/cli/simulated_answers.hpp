#pragma once

#include <functional>
#include <string>

#include "protocols/design/plan.hpp"
#include "protocols/reading/read_protocol.hpp"
#include "runner/devices/simulated/simulated_keyboard.hpp"

namespace bimodal::runner {

using Answers = std::function<std::string(const protocols::PlannedTrial&)>;

/// The answers of the project's typical simulated observer to the trials of one session; `seed`
/// decides them, other sessions have independent ones. Where one of a few options is to be chosen
/// it answers with one of their labels, by closed_set_probabilities: a label is said as the
/// protocol's word of that spelling, else as the letter-to-sound rules read it. `read` is borrowed.
[[nodiscard]] Answers simulated_answers(const protocols::ReadProtocol& read,
                                        const protocols::SessionKey& key,
                                        Seed seed);

/// How it gives them: typed, or by the stroke that stands for an option.
[[nodiscard]] SimulatedKeyboard::Options simulated_typist(const protocols::Protocol& protocol);

/// What is stored as the session's observer.
[[nodiscard]] std::string observer_name();

}  // namespace bimodal::runner
