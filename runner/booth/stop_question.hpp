#pragma once

#include <span>

#include "runner/booth/booth.hpp"
#include "runner/booth/oversight.hpp"

namespace bimodal::runner {

/// Where nothing else is typed: takes the keystrokes since the last call, and if Escape or the
/// closed window is among them, asks until it is answered. True: the session is to be stopped.
[[nodiscard]] bool stop_is_meant(const Booth& booth, Oversight& oversight);

/// The same for keystrokes that were already taken.
[[nodiscard]] bool stop_is_meant(const Booth& booth,
                                 Oversight& oversight,
                                 std::span<const Keystroke> strokes);

}  // namespace bimodal::runner
