#pragma once

#include <optional>
#include <string>

#include "runner/booth/booth.hpp"
#include "runner/booth/oversight.hpp"
#include "runner/store/records.hpp"
#include "runner/timing/refresh_estimate.hpp"

namespace bimodal::runner {

/// Shows an empty screen until the display has been watched for 100 refreshes, by which its period
/// is stated; 300 refreshes at most, for a display may stop telling, and not if the session is to
/// be stopped. A display that measures nothing is not waited for. Keystrokes are thrown away.
void watch_refreshes(const Booth& booth, Oversight& oversight);

/// Whether a screen refreshes at another rate than before: by more than 2 %, for a measured period
/// wanders by less.
[[nodiscard]] bool is_another_period(Duration period, Duration before);

/// Notices that a screen is no longer what it was when the session began.
class ScreenGuard {
 public:
  /// To be asked after each trial: why the session is to pause, or an empty text. It does if the
  /// screen reported nothing of the trial, or if its period is another than when this was asked
  /// before.
  [[nodiscard]] std::string trouble(const TrialRecord& record, const RefreshEstimate& refresh);

 private:
  std::optional<Duration> period_;
};

}  // namespace bimodal::runner
