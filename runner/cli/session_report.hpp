#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "runner/booth/session_loop.hpp"
#include "runner/cli/resumption.hpp"

namespace bimodal::runner {

/// What a session was to be, and where it is.
struct SessionFrame {
  std::size_t planned = 0;  ///< trials
  std::string data;         ///< the file
  bool predicted = false;   ///< nobody reported when its pictures were shown
};

/// Prints how a session ended; with an earlier part, of the whole session.
void report_outcome(const SessionOutcome& outcome,
                    const SessionFrame& frame,
                    const std::optional<Resumption>& earlier);

}  // namespace bimodal::runner
