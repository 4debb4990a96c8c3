#pragma once

#include <cstdint>
#include <optional>

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
           Duration refresh_period,
           Instant grid_phase,
           Instant earliest,
           Instant earliest_sound);

  [[nodiscard]] Instant first_refresh() const { return first_refresh_; }

  /// When the recording's time zero is to be seen (a refresh), and when it is to be heard.
  [[nodiscard]] Instant visual_zero() const { return visual_zero_; }

  [[nodiscard]] Instant auditory_zero() const { return visual_zero_ + layout_.av_offset; }

  /// When the sound's first sample is to be heard.
  [[nodiscard]] Instant sound_onset() const { return auditory_zero() - layout_.sound_lead; }

  /// The end of everything that is seen or heard.
  [[nodiscard]] Instant end() const { return end_; }

  /// The instant of refresh `index` (from 0); the frame to be shown then, absent after the last
  /// one.
  [[nodiscard]] Instant refresh(std::int64_t index) const;
  [[nodiscard]] std::optional<std::int64_t> frame_at(std::int64_t refresh_index) const;

  /// The refresh that follows one that was shown at `shown`: frames whose time has passed are left
  /// out rather than shown late.
  [[nodiscard]] std::int64_t refresh_after(std::int64_t index, Instant shown) const;

 private:
  StimulusLayout layout_;
  Hertz drawing_rate_;
  Duration period_;
  Instant first_refresh_;
  Instant visual_zero_;
  Instant end_;
  std::int64_t frames_ = 0;
};

}  // namespace bimodal::runner
