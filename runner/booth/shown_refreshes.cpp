#include "runner/booth/shown_refreshes.hpp"

#include <algorithm>

namespace bimodal::runner {

namespace {

/// The frame of the media file that a frame of a film shows; -1 where it is blank.
std::int64_t source_frame(const Film& film, std::int64_t frame) {
  const auto number = film.picture_of_frame[static_cast<std::size_t>(frame)];
  return number == Film::kBlank ? -1 : film.source_frame_of_picture[number];
}

}  // namespace

ShownRefreshes::ShownRefreshes(const PreparedTrial& trial, RefreshRecord& record)
    : trial_{trial},
      record_{record},
      zero_frame_{lead_frames(trial.layout, trial.drawing_rate)},
      shows_video_{trial.film && !trial.film->source_frame_of_picture.empty()} {
  const auto expected = static_cast<std::size_t>(trial.frames) + 8;
  record_.frame.reserve(expected);
  if (shows_video_) record_.source_frame.reserve(expected);
  record_.planned.reserve(expected);
  record_.shown.reserve(expected);
}

void ShownRefreshes::add(
    std::int64_t frame, Instant due, const Presentation& shown, Instant first, Duration period) {
  if (period > Duration::zero()) {
    const auto before = last_.value_or(first - period);
    const auto refreshes = (shown.onset - before + period / 2) / period;
    missed_ += static_cast<int>(std::max<std::int64_t>(refreshes - 1, 0));
  }
  last_ = shown.onset;
  if (shown.lateness < -period / 2) ++early_;
  if (shown.source == TimeSource::Predicted) ++unreported_;
  record_.frame.push_back(frame);
  if (shows_video_) record_.source_frame.push_back(source_frame(*trial_.film, frame));
  record_.planned.push_back(due.time_since_epoch());
  record_.shown.push_back(shown.onset.time_since_epoch());
  if (zero_ || frame < zero_frame_) return;
  zero_ = shown;
  zero_since_ = frame_time(trial_.layout, trial_.drawing_rate, frame);
}

void ShownRefreshes::finish(const CueSheet& cues, Duration period) {
  if (trial_.frames == 0 || period <= Duration::zero()) return;
  // A quarter of a period is forgiven, where a frame ends between two refreshes.
  auto refresh = (last_ ? *last_ + period : cues.first_refresh()) + period / 4;
  for (; cues.frame_at(refresh); refresh += period) ++missed_;
}

std::optional<Instant> ShownRefreshes::zero() const {
  if (!zero_) return std::nullopt;
  return zero_->onset - zero_since_;
}

TimeSource ShownRefreshes::source() const {
  return zero_ ? zero_->source : TimeSource::Predicted;
}

}  // namespace bimodal::runner
