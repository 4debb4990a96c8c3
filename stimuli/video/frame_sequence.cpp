#include "stimuli/video/frame_sequence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace bimodal::libav {

namespace {

constexpr int kThreads = 2;
/// A stretch that begins later than this after the first frame is sought, not decoded up to.
constexpr Duration kNear = std::chrono::seconds{4};
/// Some containers look for key frames by the time of decoding: those sought earlier, too.
constexpr std::array kEarlier{
    Duration{}, Duration{std::chrono::seconds{2}}, Duration{std::chrono::seconds{12}}};

Duration period_of(AVRational rate) {
  if (rate.num <= 0 || rate.den <= 0) return std::chrono::milliseconds{40};
  return Duration{std::llround(1e9 / av_q2d(rate))};
}

}  // namespace

FrameSequence::FrameSequence(const std::filesystem::path& file,
                             const Survey& survey,
                             Duration start)
    : file_{file}, survey_{survey} {
  open();
  const auto first = survey.media.picture->start - survey.zero;
  if (!survey.times.complete || start - first <= kNear) return;
  if (!find(start)) open();
}

void FrameSequence::open() {
  reader_.reset();
  container_.emplace(file_);
  container_->read_only(*container_->picture());
  reader_.emplace(*container_, *container_->picture(), kThreads);
}

AVRational FrameSequence::unit() const {
  return container_->picture()->time_base;
}

/// Ends at the first key frame that can be decoded; false if it is later than `start` or its number
/// unknown.
bool FrameSequence::find(Duration start) {
  for (const auto earlier : kEarlier) {
    if (!container_->seek(*container_->picture(), start + survey_.zero - earlier)) return false;
    reader_->restart();
    auto frame = new_frame();
    while (reader_->next(*frame, true)) {
      const auto time = frame->key_frame != 0 ? time_of(*frame) : std::nullopt;
      if (!time) continue;
      if (*time > start) break;
      const auto number = number_of(*time);
      if (!number) return false;
      next_index_ = *number;
      found_ = timed(std::move(frame));
      return true;
    }
  }
  return false;
}

std::optional<Decoded> FrameSequence::next() {
  if (found_) return std::exchange(found_, std::nullopt);
  auto frame = new_frame();
  if (!reader_->next(*frame)) return std::nullopt;
  return timed(std::move(frame));
}

std::optional<Duration> FrameSequence::time_of(const AVFrame& frame) const {
  const auto time = duration_of(frame.best_effort_timestamp, unit());
  if (!time) return std::nullopt;
  return *time - survey_.zero;
}

std::optional<std::int64_t> FrameSequence::number_of(Duration time) const {
  const auto& times = survey_.times;
  const auto on_file_clock = time + survey_.zero;
  if (!times.regular) {
    const auto place = std::ranges::lower_bound(times.starts, on_file_clock);
    if (place == times.starts.end() || *place != on_file_clock) return std::nullopt;
    return place - times.starts.begin();
  }
  const auto since = std::chrono::duration<double>{on_file_clock - survey_.media.picture->start};
  const double exact = since.count() * av_q2d(times.rate);
  if (exact < -0.3 || std::abs(exact - std::round(exact)) > 0.3) return std::nullopt;
  return std::llround(exact);
}

void FrameSequence::require_like_before(const AVFrame& frame, Duration time) {
  const bool first = width_ == 0;
  if (!first && (frame.width != width_ || frame.height != height_ || frame.format != format_)) {
    refuse("show",
           file_,
           fmt::format("at {} its picture changes from {} x {} to {} x {} pixels or to another "
                       "format",
                       in_seconds(time),
                       width_,
                       height_,
                       frame.width,
                       frame.height),
           "cut it there, or bring it to one size, e.g. by 'ffmpeg -i IN OUT'");
  }
  width_ = frame.width;
  height_ = frame.height;
  format_ = frame.format;
}

/// A frame without a time of its own begins where the one before it ends.
Decoded FrameSequence::timed(Frame frame) {
  Decoded made;
  const auto own = duration_of(frame->pkt_duration, unit()).value_or(Duration{});
  made.length = own > Duration{} ? own : period_of(survey_.times.rate);
  made.start = time_of(*frame).value_or(next_start_);
  require_like_before(*frame, made.start);
  if (made.start < latest_) {
    refuse("show",
           file_,
           fmt::format("at {} its frames go back in time", in_seconds(made.start)),
           "convert it again, e.g. by 'ffmpeg -i IN OUT'");
  }
  latest_ = made.start;
  next_start_ = made.start + made.length;
  made.index = next_index_++;
  made.frame = std::move(frame);
  return made;
}

}  // namespace bimodal::libav
