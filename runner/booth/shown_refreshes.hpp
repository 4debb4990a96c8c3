#pragma once

#include <optional>

#include "runner/devices/display.hpp"
#include "runner/preparation/trial_preparer.hpp"
#include "runner/session/cue_sheet.hpp"
#include "runner/store/records.hpp"

namespace bimodal::runner {

/// What the screen did with the frames of one trial. Adding allocates nothing up to the trial's
/// number of frames and a few more.
class ShownRefreshes {
 public:
  ShownRefreshes(const PreparedTrial& trial, RefreshRecord& record);

  /// Frame `frame` was to be shown at `due`, and was; `period` is the screen's. Gaps are counted
  /// from `first`, the refresh at which frames were to begin.
  void add(
      std::int64_t frame, Instant due, const Presentation& shown, Instant first, Duration period);

  /// Nothing more is shown: counts the refreshes up to the end of the frames that `cues` plans.
  void finish(const CueSheet& cues, Duration period);

  /// When the recording's time zero was shown: if its own frame was left out, when it would have
  /// been by the first one after it. Absent: it was not.
  [[nodiscard]] std::optional<Instant> zero() const;

  /// By whose word.
  [[nodiscard]] TimeSource source() const;

  /// Refreshes at which a frame was due and none was shown: at the beginning, in between, at the
  /// end.
  [[nodiscard]] int missed() const { return missed_; }

  /// Frames that were shown more than half a period before they were due.
  [[nodiscard]] int early() const { return early_; }

  /// Refreshes that showed a frame.
  [[nodiscard]] int count() const { return static_cast<int>(record_.frame.size()); }

  /// Refreshes of which nobody reported when they took place.
  [[nodiscard]] int unreported() const { return unreported_; }

 private:
  const PreparedTrial& trial_;
  RefreshRecord& record_;
  std::int64_t zero_frame_;
  bool shows_video_;
  std::optional<Instant> last_;
  std::optional<Presentation> zero_;  ///< of the first frame not before time zero
  Duration zero_since_{};             ///< which time of the recording that frame shows
  int missed_ = 0;
  int early_ = 0;
  int unreported_ = 0;
};

}  // namespace bimodal::runner
