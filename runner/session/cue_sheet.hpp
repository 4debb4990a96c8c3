#pragma once

#include <cstdint>
#include <optional>

#include "runner/timing/refresh_estimate.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// How long the parts of a stimulus last. Time zero of the recording is the common reference of
/// what is heard and what is seen.
struct StimulusLayout {
  Duration recording{};    ///< length of the recording
  Duration lead{};         ///< still picture before it
  Duration trail{};        ///< still picture after it
  Duration sound_lead{};   ///< noise or silence before the recording, inside the sound
  Duration sound_trail{};  ///< and after it
  Duration av_offset{};    ///< audio minus visual: positive, audio lags
  bool has_sound = false;
};

/// The number of prepared frames at the drawing rate; frame lead_frames() shows the recording's
/// time zero.
[[nodiscard]] std::int64_t frame_count(const StimulusLayout& layout, Hertz drawing_rate);
[[nodiscard]] std::int64_t lead_frames(const StimulusLayout& layout, Hertz drawing_rate);

/// The recording's time that frame `index` shows: negative in the lead.
[[nodiscard]] Duration frame_time(const StimulusLayout& layout,
                                  Hertz drawing_rate,
                                  std::int64_t index);

/// The rate at which frames are prepared for a measured refresh period: the nearest whole number of
/// frames a second, or n * 1000 / 1001 of it, if that is within 0.2 %, else the measured rate
/// itself.
[[nodiscard]] Hertz drawing_rate_for(Duration refresh_period);

/// What happens when, on the session clock.
class CueSheet {
 public:
  /// Places the stimulus on the refresh grid: its first refresh is the first grid instant not
  /// before `earliest`, and late enough for the sound to begin not before `earliest_sound`.
  CueSheet(const StimulusLayout& layout,
           Hertz drawing_rate,
           const RefreshEstimate& grid,
           Instant earliest,
           Instant earliest_sound);

  /// Moves everything onto the grid as it is known by now: time zero goes to the refresh nearest to
  /// where it was. A screen that keeps its rhythm moves nothing; one that wanders (a compositor
  /// with a timer of its own) takes the stimulus along, as long as its sound has not begun.
  void follow(const RefreshEstimate& grid);

  [[nodiscard]] Instant first_refresh() const { return visual_zero_ - to_zero_; }

  /// When the recording's time zero is to be seen (a refresh), and when it is to be heard.
  [[nodiscard]] Instant visual_zero() const { return visual_zero_; }

  [[nodiscard]] Instant auditory_zero() const { return visual_zero_ + layout_.av_offset; }

  /// When the sound's first sample is to be heard.
  [[nodiscard]] Instant sound_onset() const { return auditory_zero() - layout_.sound_lead; }

  /// The end of everything that is seen or heard.
  [[nodiscard]] Instant end() const;

  /// The frame nearest to what is to be seen at `refresh`: absent before the first and after the
  /// last one. Frames whose time has passed are left out rather than shown late.
  [[nodiscard]] std::optional<std::int64_t> frame_at(Instant refresh) const;

 private:
  void place(const RefreshEstimate& grid);

  StimulusLayout layout_;
  Hertz drawing_rate_;
  std::int64_t frames_ = 0;
  std::int64_t zero_frame_ = 0;
  Duration to_zero_{};  ///< from the first refresh to time zero: whole refreshes
  Instant visual_zero_;
};

}  // namespace bimodal::runner
