#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "runner/devices/clock.hpp"
#include "runner/devices/presentation_reports.hpp"
#include "runner/devices/x11/sync_control.hpp"

namespace bimodal::runner {

/// The driver's word on when an X11 window's pictures were shown, through GLX_OML_sync_control
/// (revision 6.0, 2003), as Psychtoolbox uses it: Mesa's drivers hand on what the kernel stamped at
/// the page flip. If a compositing window manager copies the window (it does not if it lets
/// full-screen windows through), the stamp is that of the copy, a refresh before it is visible.
///
/// Tested by injected answers only: no hardware that has the extension has been at hand, and the
/// software renderer has not got it.
class OmlReports final : public PresentationReports {
 public:
  using Sleep = std::function<void(Instant)>;

  /// `clock` is borrowed; `sleep` sleeps until an instant of it. Waiting asks every half
  /// millisecond whether the swap is done, because the driver's own wait knows no end.
  OmlReports(std::unique_ptr<SyncControl> control, const Clock& clock, Sleep sleep);

  void request() override;

  /// Answers that belong to another swap are discarded, and swaps are counted anew from there.
  [[nodiscard]] std::optional<PresentationReport> await(Duration patience,
                                                        const Meanwhile& meanwhile) override;

  [[nodiscard]] TimeSource source() const override { return TimeSource::DriverReported; }

  [[nodiscard]] Duration stated_period() const override { return Duration::zero(); }

  [[nodiscard]] std::string_view name() const override { return "GLX_OML_sync_control"; }

  [[nodiscard]] std::string description() const override;

  [[nodiscard]] bool by_hardware() const override { return true; }

 private:
  [[nodiscard]] bool is_done(Instant until, const Meanwhile& meanwhile);

  std::unique_ptr<SyncControl> control_;
  const Clock& clock_;  ///< borrowed
  Sleep sleep_;
  std::int64_t swaps_ = 0;  ///< number of the swap that was last asked about
};

}  // namespace bimodal::runner
