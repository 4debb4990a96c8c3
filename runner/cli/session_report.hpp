#pragma once

#include <cstddef>
#include <string>

#include "runner/booth/session_loop.hpp"

namespace bimodal::runner {

/// Prints how a session ended, of how many trials that were planned, and where its data are.
void report_outcome(const SessionOutcome& outcome, std::size_t planned, const std::string& data);

}  // namespace bimodal::runner
