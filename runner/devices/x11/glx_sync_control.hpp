#pragma once

#include <memory>
#include <string>

#include "runner/devices/x11/sync_control.hpp"

namespace bimodal::runner {

/// GLX_OML_sync_control of the window and context that are current in this thread, or why there is
/// none.
struct FoundSyncControl {
  std::unique_ptr<SyncControl> control;
  std::string refusal;
};

[[nodiscard]] FoundSyncControl find_sync_control();

}  // namespace bimodal::runner
