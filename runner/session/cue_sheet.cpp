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
                   const RefreshEstimate& grid,
                   Instant earliest,
                   Instant earliest_sound)
    : layout_{layout},
      drawing_rate_{drawing_rate},
      frames_{frame_count(layout, drawing_rate)},
      zero_frame_{lead_frames(layout, drawing_rate)} {
  assert(grid.period > Duration::zero());
  place(grid);
  if (layout.has_sound) {
    const auto sound_before_first = layout.sound_lead - layout.av_offset - to_zero_;
    earliest = std::max(earliest, earliest_sound + sound_before_first);
  }
  visual_zero_ = refresh_not_before(grid, earliest) + to_zero_;
}

/// On the grid: the refresh at which the frame of time zero is due, whatever the rates.
void CueSheet::place(const RefreshEstimate& grid) {
  const double lead_s = static_cast<double>(zero_frame_) / drawing_rate_.count();
  to_zero_ = std::int64_t{std::llround(lead_s / seconds(grid.period))} * grid.period;
}

void CueSheet::follow(const RefreshEstimate& grid) {
  place(grid);
  visual_zero_ = nearest_refresh(grid, visual_zero_);
}

Instant CueSheet::end() const {
  const auto rest = static_cast<double>(frames_ - zero_frame_) / drawing_rate_.count();
  const auto seen = visual_zero_ + from_seconds(rest);
  if (!layout_.has_sound) return seen;
  return std::max(seen, auditory_zero() + layout_.recording + layout_.sound_trail);
}

std::optional<std::int64_t> CueSheet::frame_at(Instant refresh) const {
  const double since_zero = seconds(refresh - visual_zero_);
  const auto nearest = zero_frame_ + std::llround(since_zero * drawing_rate_.count());
  // Where the rates differ, the lead may be half a frame longer on the screen.
  const auto frame = refresh >= first_refresh() ? std::max<std::int64_t>(nearest, 0) : nearest;
  if (frame < 0 || frame >= frames_) return std::nullopt;
  return frame;
}

}  // namespace bimodal::runner
