#pragma once

#include <memory>
#include <optional>

#include "stimuli/base/quantity.hpp"

struct wl_display;
struct wl_surface;

namespace bimodal::runner {

/// The compositor's own word on when a surface's new content was shown. For the thread that swaps.
///
/// It is needed because under Wayland a swap does not return at the refresh that shows its picture,
/// but at the one before.
class SurfaceFeedback {
 public:
  enum class Kind {
    Presented,   ///< wp_presentation (presentation-time, version 1): when it became visible
    FrameDrawn,  ///< wl_surface.frame: when the compositor, having drawn it, asks for the next one;
                 ///< on a real screen up to one refresh before it is visible
  };

  /// `display` and `surface` are borrowed from the window, which must outlive this.
  SurfaceFeedback(wl_display* display, wl_surface* surface);
  SurfaceFeedback(const SurfaceFeedback&) = delete;
  SurfaceFeedback& operator=(const SurfaceFeedback&) = delete;
  SurfaceFeedback(SurfaceFeedback&&) = delete;
  SurfaceFeedback& operator=(SurfaceFeedback&&) = delete;
  ~SurfaceFeedback();

  /// Presented is offered only where the compositor has it, and by CLOCK_MONOTONIC. Even then it
  /// may never answer (wlroots 0.15 without a screen).
  [[nodiscard]] bool offers(Kind kind) const;

  /// Asks about the content of the next swap. What was asked before and not awaited is forgotten.
  void request(Kind kind);

  /// Blocks until the compositor has answered what was last asked, at most `patience`: when the
  /// content was first shown. Nothing: it was not (window hidden, content replaced), or no answer.
  [[nodiscard]] std::optional<Instant> await(Duration patience);

  /// The period that the compositor stated with the last Presented, 0 where it stated none.
  [[nodiscard]] Duration stated_period() const;

  /// Whether the last Presented was stamped by the display hardware and not by the compositor.
  [[nodiscard]] bool hardware_stamped() const;

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;
};

}  // namespace bimodal::runner
