#pragma once

#include <memory>

#include "runner/devices/display.hpp"
#include "runner/devices/monotonic_clock.hpp"
#include "runner/devices/sdl/screen_painter.hpp"
#include "runner/devices/sdl/sdl_window.hpp"
#include "runner/devices/wayland/surface_feedback.hpp"
#include "runner/timing/pacing.hpp"
#include "runner/timing/refresh_meter.hpp"

namespace bimodal::runner {

/// A real screen. Where the instant of a presentation comes from is found out at start-up:
///  - Wayland with wp_presentation: the compositor's report (driver_reported);
///  - Wayland without its answers: the instant at which the compositor, having drawn the window,
///  let
///    the swap's caller go on (swap_returned; on a real screen up to one refresh too early);
///  - a driver whose swap waits for the refresh: the instant at which glFinish returned after the
///    swap (swap_returned);
///  - neither (Xvfb, no vertical sync): refreshes of the nominal rate are kept by the clock and
///    the onset is the instant at which the drawn screen was handed over (predicted).
/// A presentation that got no report is "predicted" by itself, whatever the others are.
class SdlDisplay final : public Display {
 public:
  /// Measures the refresh over 100 flips after 20 that are not counted: 2 s at 60 Hz, in which
  /// `opening` is on the screen. `window` is borrowed and must outlive the display; one thread uses
  /// both.
  explicit SdlDisplay(SdlWindow& window, const Screen& opening = {});

  Presentation present(const Screen& screen, Instant deadline) override;

  [[nodiscard]] RefreshEstimate refresh() const override;
  [[nodiscard]] std::optional<DeviceClock> clock() const override;

  [[nodiscard]] std::string kind() const override { return "sdl"; }

  [[nodiscard]] std::string description() const override;

  [[nodiscard]] TimeSource time_source() const override { return source_; }

  /// What was irregular since start-up.
  [[nodiscard]] const RefreshCounts& counts() const { return meter_.counts(); }

 private:
  void measure_refresh(const Screen& opening);
  [[nodiscard]] bool measure_answers(SurfaceFeedback::Kind kind, const Screen& opening);
  [[nodiscard]] bool measure_swaps(const Screen& opening);
  [[nodiscard]] std::string describe_source() const;
  void wait_until(Instant instant);
  Presentation present_answered(const RefreshPlan& plan);
  Presentation present_swapped(const RefreshPlan& plan);
  Presentation present_clocked(const RefreshPlan& plan);

  SdlWindow& window_;  ///< borrowed
  ScreenPainter painter_;
  MonotonicClock clock_;
  std::unique_ptr<SurfaceFeedback> feedback_;  ///< under Wayland
  SurfaceFeedback::Kind answer_ = SurfaceFeedback::Kind::Presented;
  RefreshMeter meter_;
  RefreshEstimate nominal_;  ///< where nothing can be measured
  TimeSource source_ = TimeSource::Predicted;
};

}  // namespace bimodal::runner
