#pragma once

#include <cstdint>
#include <optional>

#include "runner/timing/presentation_report.hpp"

namespace bimodal::runner {

/// The two questions of GLX_OML_sync_control that are asked about one window, so that the answers
/// can be given by a test. For the thread that swaps.
class SyncControl {
 public:
  SyncControl() = default;
  SyncControl(const SyncControl&) = delete;
  SyncControl& operator=(const SyncControl&) = delete;
  SyncControl(SyncControl&&) = delete;
  SyncControl& operator=(SyncControl&&) = delete;
  virtual ~SyncControl() = default;

  /// The counters as they are now (glXGetSyncValuesOML); absent: the driver does not say.
  [[nodiscard]] virtual std::optional<SyncCounters> counters() = 0;

  /// The counters as they were when swap number `swap` was done (glXWaitForSbcOML). Blocks until it
  /// is, without end.
  [[nodiscard]] virtual std::optional<SyncCounters> await_swap(std::int64_t swap) = 0;
};

}  // namespace bimodal::runner
