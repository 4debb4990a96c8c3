#include "runner/session/cue_sheet.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace bimodal::runner {

namespace {

double seconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

Duration from_seconds(double value) {
  return Duration{std::llround(value * 1e9)};
}

/// The fewest frames that last at least `duration`; a millionth of a frame is forgiven, so that
/// half a second at 60 Hz is 30 frames whatever the last digit says.
std::int64_t frames_covering(Duration duration, Hertz rate) {
  return static_cast<std::int64_t>(std::ceil(seconds(duration) * rate.count() - 1e-6));
}

}  // namespace

std::int64_t lead_frames(const StimulusLayout& layout, Hertz drawing_rate) {
  return frames_covering(layout.lead, drawing_rate);
}

std::int64_t frame_count(const StimulusLayout& layout, Hertz drawing_rate) {
  return lead_frames(layout, drawing_rate) +
         frames_covering(layout.recording + layout.trail, drawing_rate);
}

Duration frame_time(const StimulusLayout& layout, Hertz drawing_rate, std::int64_t index) {
  return from_seconds(static_cast<double>(index - lead_frames(layout, drawing_rate)) /
                      drawing_rate.count());
}

Hertz drawing_rate_for(Duration refresh_period) {
  assert(refresh_period > Duration::zero());
  const double measured = 1.0 / seconds(refresh_period);
  constexpr double kTolerance = 0.002;
  const double whole = std::round(measured);
  Hertz best{measured};
  double smallest = kTolerance;
  for (const double rate : std::array{whole, whole * 1000.0 / 1001.0}) {
    const double deviation = std::abs(measured / rate - 1.0);
    if (deviation < smallest - 1e-4) {  // the whole number wins unless the other is clearly nearer
      best = Hertz{rate};
      smallest = deviation;
    }
  }
  return best;
}

CueSheet::CueSheet(const StimulusLayout& layout,
                   Hertz drawing_rate,
                   Duration refresh_period,
                   Instant grid_phase,
                   Instant earliest,
                   Instant earliest_sound)
    : layout_{layout},
      drawing_rate_{drawing_rate},
      period_{refresh_period},
      frames_{frame_count(layout, drawing_rate)} {
  // On the grid: the refresh at which the frame of time zero is due, whatever the rates.
  const double lead_s =
      static_cast<double>(lead_frames(layout, drawing_rate)) / drawing_rate.count();
  const Duration to_zero = std::int64_t{std::llround(lead_s / seconds(period_))} * period_;
  if (layout.has_sound) {
    const auto sound_before_first = layout.sound_lead - layout.av_offset - to_zero;
    earliest = std::max(earliest, earliest_sound + sound_before_first);
  }
  const auto since = (earliest - grid_phase).count();
  const auto period = period_.count();
  const auto refreshes = since >= 0 ? (since + period - 1) / period : -(-since / period);
  first_refresh_ = grid_phase + Duration{refreshes * period};
  visual_zero_ = first_refresh_ + to_zero;
  end_ = first_refresh_ + from_seconds(static_cast<double>(frames_) / drawing_rate.count());
  if (layout.has_sound) {
    end_ = std::max(end_, auditory_zero() + layout.recording + layout.sound_trail);
  }
}

Instant CueSheet::refresh(std::int64_t index) const {
  return first_refresh_ + index * period_;
}

std::optional<std::int64_t> CueSheet::frame_at(std::int64_t refresh_index) const {
  const double since = seconds(refresh_index * period_);
  const auto frame = static_cast<std::int64_t>(std::llround(since * drawing_rate_.count()));
  if (frame >= frames_) return std::nullopt;
  return frame;
}

std::int64_t CueSheet::refresh_after(std::int64_t index, Instant shown) const {
  const double since = seconds(shown - first_refresh_) / seconds(period_);
  return std::max(index + 1, static_cast<std::int64_t>(std::llround(since)) + 1);
}

}  // namespace bimodal::runner
