#pragma once

#include "runner/booth/booth.hpp"
#include "runner/booth/oversight.hpp"

namespace bimodal::runner {

/// Shows an empty screen until the display has been watched for 100 refreshes, by which its period
/// is stated; 300 refreshes at most, for a display may stop telling, and not if the session is to
/// be stopped. A display that measures nothing is not waited for. Keystrokes are thrown away.
void watch_refreshes(const Booth& booth, Oversight& oversight);

}  // namespace bimodal::runner
