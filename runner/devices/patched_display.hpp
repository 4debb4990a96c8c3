#pragma once

#include <optional>
#include <string>

#include "runner/devices/display.hpp"

namespace bimodal::runner {

/// A box on the screen that a photodiode watches.
struct Patch {
  Mark at_rest;           ///< a box in its colour at all times but
  Mark at_zero;           ///< from the refresh of time zero on,
  Duration length{};      ///< for so long
  std::string described;  ///< "60 pixels in the upper-left corner, white on black"
};

/// A display with a patch for a photodiode on every screen, above what it covers. The patch changes
/// with the screen that is `at_zero`. Presenting allocates nothing as long as screens have no
/// captions.
class PatchedDisplay final : public Display {
 public:
  /// `display` is borrowed and must outlive this.
  PatchedDisplay(Display& display, Patch patch);

  Presentation present(const Screen& screen, Instant deadline) override;

  void wait(Instant until) override { display_.wait(until); }

  [[nodiscard]] RefreshEstimate refresh() const override { return display_.refresh(); }

  [[nodiscard]] std::optional<DeviceClock> clock() const override { return display_.clock(); }

  [[nodiscard]] std::string kind() const override { return display_.kind(); }

  [[nodiscard]] std::string description() const override;

  [[nodiscard]] TimeSource time_source() const override { return display_.time_source(); }

 private:
  [[nodiscard]] bool still_lit(Instant deadline) const;

  Display& display_;  ///< borrowed
  Patch patch_;
  Screen shown_;                 ///< the last screen, with the patch
  Instant last_{};               ///< its onset
  std::optional<Instant> zero_;  ///< since when the patch has the colour of time zero
};

}  // namespace bimodal::runner
