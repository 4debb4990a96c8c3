#pragma once

#include <string>

#include "runner/devices/display.hpp"

namespace bimodal::runner {

// What the participant reads.

/// A page of text that waits for Enter.
[[nodiscard]] Screen page_screen(std::string text);

/// The prompt, and what has been typed so far.
[[nodiscard]] Screen answer_screen(const std::string& prompt, const std::string& answer);

/// Asks whether the session is to end.
[[nodiscard]] Screen stop_question();

/// The next trial is not ready.
[[nodiscard]] Screen waiting_screen();

/// During a pause, whatever its reason.
[[nodiscard]] Screen pause_screen();

}  // namespace bimodal::runner
