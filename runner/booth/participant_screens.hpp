#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "protocols/model/response.hpp"
#include "runner/devices/display.hpp"
#include "runner/session/option_grid.hpp"

namespace bimodal::runner {

// What the participant reads.

/// A page of text that waits for Enter.
[[nodiscard]] Screen page_screen(std::string text);

/// The prompt, and what has been typed so far.
[[nodiscard]] Screen answer_screen(const std::string& prompt, const std::string& answer);

/// The prompt, and all options in their boxes: the label, below it its key or button. The chosen
/// one has a frame. `background`: of the window, 0xRRGGBB, from which the boxes stand out a little.
[[nodiscard]] Screen choice_screen(const protocols::Response& response,
                                   const OptionGrid& grid,
                                   std::optional<std::size_t> chosen,
                                   std::uint32_t background);

/// Asks whether the session is to end.
[[nodiscard]] Screen stop_question();

/// The next trial is not ready.
[[nodiscard]] Screen waiting_screen();

/// During a pause because something went wrong here.
[[nodiscard]] Screen trouble_screen();

/// During a pause that the experimenter asked for.
[[nodiscard]] Screen pause_screen();

}  // namespace bimodal::runner
