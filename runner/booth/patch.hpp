#pragma once

#include <cstdint>
#include <optional>

#include "protocols/model/triggers.hpp"
#include "runner/devices/patched_display.hpp"
#include "runner/preparation/trial_preparer.hpp"
#include "runner/session/cue_sheet.hpp"

namespace bimodal::runner {

/// The patch that a protocol asks for, in a window of so many pixels.
[[nodiscard]] Patch patch_of(const protocols::Photodiode& photodiode, int width, int height);

/// Finds the one refresh of a stimulus that is "at zero" (see Screen): where somebody is seen, the
/// first that shows a frame not before time zero; where something is only heard, the one nearest to
/// its planned auditory zero.
class ZeroCue {
 public:
  ZeroCue(const PreparedTrial& trial, const CueSheet& cues);

  /// Whether the refresh at `due`, which shows `frame` if there is one, is it. Refreshes come in
  /// their order, with gaps where some are left out; `period` is the screen's.
  [[nodiscard]] bool is_next(Instant due, std::optional<std::int64_t> frame, Duration period) const;

  /// It has been shown.
  void pass() { passed_ = true; }

 private:
  const CueSheet& cues_;
  bool has_picture_;
  std::int64_t zero_frame_;
  bool passed_ = false;
};

}  // namespace bimodal::runner
