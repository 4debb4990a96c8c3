#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "runner/devices/display.hpp"
#include "runner/timing/presentation_report.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// Somebody who tells when a window's pictures were shown: the compositor, the driver. For the
/// thread that swaps. Who they are, best first:
///  - Wayland, wp_presentation: the compositor's report (wayland/surface_feedback.hpp);
///  - X11, GLX_OML_sync_control: the driver's report (x11/oml_reports.hpp);
///  - Wayland, frame callbacks: the compositor asks for the next picture.
/// KMSDRM, a console without a window system, reports nothing, and needs not: with double buffering
/// (which SdlWindow asks for) SDL 2's swap returns when the page has been flipped, so that the
/// instant of its return is that of the refresh and the time it takes the kernel to wake us.
class PresentationReports {
 public:
  /// What is done while an answer is awaited, about every millisecond.
  using Meanwhile = std::function<void()>;

  PresentationReports() = default;
  PresentationReports(const PresentationReports&) = delete;
  PresentationReports& operator=(const PresentationReports&) = delete;
  PresentationReports(PresentationReports&&) = delete;
  PresentationReports& operator=(PresentationReports&&) = delete;
  virtual ~PresentationReports() = default;

  /// Asks about the content of the next swap; to be called before every one. What was asked before
  /// and not awaited is forgotten.
  virtual void request() = 0;

  /// Blocks until what was last asked has been answered, at most `patience`. Nothing: the content
  /// was not shown (window hidden, content replaced), or no answer. Throws DisplayLost if whoever
  /// answers is gone.
  [[nodiscard]] virtual std::optional<PresentationReport> await(Duration patience,
                                                                const Meanwhile& meanwhile) = 0;

  /// What an answered presentation rests on.
  [[nodiscard]] virtual TimeSource source() const = 0;

  /// Whether the last answer was stamped by the display hardware or its driver.
  [[nodiscard]] virtual bool by_hardware() const { return false; }

  /// The refresh period stated with the last answer; 0: none was.
  [[nodiscard]] virtual Duration stated_period() const = 0;

  /// "wp_presentation", "GLX_OML_sync_control", "frame callbacks".
  [[nodiscard]] virtual std::string_view name() const = 0;

  /// What its instants are, and who stamped the last.
  [[nodiscard]] virtual std::string description() const = 0;
};

}  // namespace bimodal::runner
