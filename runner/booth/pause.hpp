#pragma once

#include "runner/booth/booth.hpp"
#include "runner/booth/oversight.hpp"

namespace bimodal::runner {

enum class PauseEnd { Resumed, Stopped };

/// Shows the page of a pause, at every refresh, until nobody asks for the pause any more, or the
/// session is to be stopped: by request, by Ctrl-C, or by Escape, after the usual question. A pause
/// of the session's own also ends by Enter. All other keys are thrown away. The reason (the
/// experimenter's wish, a device's fault) is what `oversight` was asked with; whoever watches is
/// told it, the participant is not.
[[nodiscard]] PauseEnd hold_pause(const Booth& booth, Oversight& oversight);

}  // namespace bimodal::runner
