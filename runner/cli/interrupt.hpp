#pragma once

namespace bimodal::runner {

/// From now on the first Ctrl-C, SIGTERM or SIGHUP (the terminal is closed) asks the session to
/// stop, and a second ends the program as usual.
void stop_at_interrupt();

/// Whether the first has come.
[[nodiscard]] bool interrupt_asked();

}  // namespace bimodal::runner
