#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "runner/booth/session_loop.hpp"
#include "runner/cli/resumption.hpp"

namespace bimodal::runner {

/// Prints how a session ended, of how many trials that were planned, and where its data are; with
/// an earlier part, of the whole session.
void report_outcome(const SessionOutcome& outcome,
                    std::size_t planned,
                    const std::optional<Resumption>& earlier,
                    const std::string& data);

}  // namespace bimodal::runner
