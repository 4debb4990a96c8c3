#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "runner/devices/presentation_reports.hpp"
#include "stimuli/base/quantity.hpp"

struct wl_display;
struct wl_surface;

namespace bimodal::runner {

/// The compositor's own word on when a surface's new content was shown.
///
/// It is needed because under Wayland a swap does not return at the refresh that shows its picture,
/// but at the one before.
///
/// Instants of wp_presentation are on the clock that the compositor names: CLOCK_MONOTONIC where
/// the display hardware stamps, CLOCK_MONOTONIC_RAW in Weston without hardware. Another clock of
/// this machine is read beside the session clock with every answer, and the difference taken off.
///
/// Who answers, as seen in the traffic between SDL 2.26 and the compositor: Weston 10 on an X
/// server answers every picture. Sway 1.7 (wlroots 0.15) without a screen never does, and on an X
/// server only when the next picture is shown, with that one's instant: those back ends give the
/// presentation another number than the commit whose feedback waits for it (read in
/// types/wlr_presentation_time.c and backend/headless/output.c), so that no request of ours,
/// however placed, can be answered. There frame callbacks are what is left.
class SurfaceFeedback final : public PresentationReports {
 public:
  enum class Kind {
    Presented,   ///< wp_presentation (presentation-time, version 1): when it became visible
    FrameDrawn,  ///< wl_surface.frame: when the compositor, having drawn it, asks for the next one;
                 ///< on a real screen up to one refresh before it is visible
  };

  /// `display` and `surface` are borrowed from the window, which must outlive this.
  SurfaceFeedback(wl_display* display, wl_surface* surface, Kind kind);
  SurfaceFeedback(const SurfaceFeedback&) = delete;
  SurfaceFeedback& operator=(const SurfaceFeedback&) = delete;
  SurfaceFeedback(SurfaceFeedback&&) = delete;
  SurfaceFeedback& operator=(SurfaceFeedback&&) = delete;
  ~SurfaceFeedback() override;

  /// Why it cannot be asked; empty: it can (which does not mean that it will answer).
  [[nodiscard]] std::string refusal() const;

  /// Only if there is no refusal.
  void request() override;

  [[nodiscard]] std::optional<PresentationReport> await(Duration patience,
                                                        const Meanwhile& meanwhile) override;

  [[nodiscard]] TimeSource source() const override;

  [[nodiscard]] Duration stated_period() const override;

  [[nodiscard]] std::string_view name() const override;

  [[nodiscard]] std::string description() const override;
  [[nodiscard]] bool by_hardware() const override;

 private:
  struct Connection;
  Kind kind_;
  std::unique_ptr<Connection> connection_;
};

}  // namespace bimodal::runner
