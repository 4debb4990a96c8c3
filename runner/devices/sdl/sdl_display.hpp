#pragma once

#include <memory>
#include <span>
#include <string>

#include "runner/devices/display.hpp"
#include "runner/devices/monotonic_clock.hpp"
#include "runner/devices/presentation_reports.hpp"
#include "runner/devices/sdl/screen_painter.hpp"
#include "runner/devices/sdl/sdl_window.hpp"
#include "runner/timing/pacing.hpp"
#include "runner/timing/refresh_meter.hpp"
#include "runner/timing/start_up_gate.hpp"

namespace bimodal::runner {

/// A real screen. Where the instant of a presentation comes from is found out at start-up, best
/// first; what is not used, and why, is in the description:
///  - Wayland with wp_presentation: the compositor's report (driver_reported);
///  - X11 with GLX_OML_sync_control: the driver's report (driver_reported);
///  - Wayland without reports: the instant at which the compositor, having drawn the window, asks
///    for the next picture (swap_returned; on a real screen up to one refresh too early);
///  - a driver whose swap waits for the refresh (X11, KMSDRM): the instant at which glFinish
///    returned after the swap (swap_returned);
///  - none of these (Xvfb, no vertical sync): refreshes of the nominal rate are kept by the clock
///    and the onset is the instant at which the drawn screen was handed over (predicted).
/// Reports are used only if they are plausible (judge_reports). A presentation that got no report
/// is "predicted" by itself, whatever the others are. While it waits, events are taken in every
/// millisecond.
class SdlDisplay final : public Display {
 public:
  /// Measures the refresh over 100 flips after 20 that are not counted: 2 s at 60 Hz, in which
  /// `opening` is on the screen. `window` is borrowed and must outlive the display; one thread uses
  /// both.
  explicit SdlDisplay(SdlWindow& window, const Screen& opening = {});

  Presentation present(const Screen& screen, Instant deadline) override;
  void wait(Instant until) override;

  [[nodiscard]] RefreshEstimate refresh() const override;
  [[nodiscard]] std::optional<DeviceClock> clock() const override;

  [[nodiscard]] std::string kind() const override { return "sdl"; }

  [[nodiscard]] std::string description() const override;

  [[nodiscard]] TimeSource time_source() const override { return source_; }

  /// What was measured at start-up, for judge().
  [[nodiscard]] const StartUp& start_up() const { return start_up_; }

  /// What was irregular since start-up.
  [[nodiscard]] const RefreshCounts& counts() const { return meter_.counts(); }

 private:
  void measure_refresh(const Screen& opening);
  [[nodiscard]] std::string measure_reports(const Screen& opening);
  [[nodiscard]] bool measure_swaps(const Screen& opening);
  void sum_up(std::span<const Instant> flips);
  [[nodiscard]] std::string describe_source() const;
  Presentation present_reported(const RefreshPlan& plan);
  Presentation present_swapped(const RefreshPlan& plan);
  Presentation present_clocked(const RefreshPlan& plan);

  SdlWindow& window_;  ///< borrowed
  ScreenPainter painter_;
  MonotonicClock clock_;
  PresentationReports::Meanwhile pump_;
  std::unique_ptr<PresentationReports> reports_;  ///< that are used, if any
  bool counted_ = false;                          ///< they count refreshes
  Instant last_shown_;                            ///< by their word
  std::string not_used_;                          ///< better sources, each with the reason
  RefreshMeter meter_;
  RefreshEstimate nominal_;  ///< where nothing can be measured
  StartUp start_up_;
  TimeSource source_ = TimeSource::Predicted;
};

}  // namespace bimodal::runner
