#include "runner/preparation/natural_talker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "stimuli/video/frame_reader.hpp"

namespace bimodal::runner {

namespace {

/// A frame that begins this much later than asked for is still meant: times in containers are
/// rounded to milliseconds.
constexpr Duration kForgiven = std::chrono::microseconds{1'100};

struct KeptFrame {
  std::int64_t index = 0;
  Duration start{};
  std::shared_ptr<const Image> image;
};

std::vector<KeptFrame> decode(const RecordedSource& source,
                              std::size_t lines,
                              const Checkpoint& checkpoint) {
  FrameReader reader{source.path, {.height = lines, .span = source.span}};
  const std::size_t bytes_each = reader.width() * reader.height() * 4;
  std::vector<KeptFrame> frames;
  while (auto frame = reader.next()) {
    if ((frames.size() + 1) * bytes_each > kMostFrameBytes) {
      throw Error{
          fmt::format("the video of item '{}' in '{}' does not fit into memory: more than {} "
                      "frames of {} x {}; "
                      "lower \"height\" or \"lines\" of its look, or cut the item shorter",
                      source.item,
                      source.path.string(),
                      frames.size(),
                      reader.width(),
                      reader.height())};
    }
    checkpoint();
    frames.push_back(
        {frame->index, frame->start, std::make_shared<const Image>(std::move(frame->image))});
  }
  if (frames.empty()) {
    throw Error{fmt::format("item '{}' of '{}' shows no frame", source.item, source.path.string())};
  }
  return frames;
}

class NaturalTalker final : public FrameSource {
 public:
  NaturalTalker(const Enactment& enactment,
                std::size_t lines,
                Hertz drawing_rate,
                const Checkpoint& checkpoint)
      : enactment_{enactment},
        half_refresh_{std::llround(0.5e9 / drawing_rate.count())},
        frames_{decode(*enactment.picture_source, lines, checkpoint)},
        frame_length_{mean_frame_length()} {}

  [[nodiscard]] std::int64_t picture_at(Duration time) override {
    return static_cast<std::int64_t>(place_at(time));
  }

  [[nodiscard]] std::shared_ptr<const Image> paint(Duration time) override {
    return frames_[place_at(time)].image;
  }

  [[nodiscard]] std::optional<std::int64_t> source_frame(std::int64_t number) const override {
    return frames_.at(static_cast<std::size_t>(number)).index;
  }

 private:
  [[nodiscard]] Duration mean_frame_length() const {
    if (frames_.size() < 2) return enactment_.length;
    return (frames_.back().start - frames_.front().start) /
           static_cast<std::int64_t>(frames_.size() - 1);
  }

  [[nodiscard]] std::size_t place_at(Duration time) const {
    const auto instant = recording_time(enactment_, time + half_refresh_);
    if (enactment_.rate <= 1.0) return place_of(instant);
    // So many times as fast, each frame that is shown stands for so many frames, counted from the
    // first, of which it is the one that comes first.
    const auto step = std::chrono::round<Duration>(frame_length_ * enactment_.rate);
    const auto first = frames_.front().start;
    const auto begin = first + std::max(instant - first, Duration{}) / step * step;
    return place_of(enactment_.reversed ? begin + step - kForgiven : begin + kForgiven);
  }

  /// The last frame that begins by then.
  [[nodiscard]] std::size_t place_of(Duration instant) const {
    const auto after = std::ranges::upper_bound(
        frames_, instant, {}, [](const KeptFrame& frame) { return frame.start; });
    return after == frames_.begin() ? 0 : static_cast<std::size_t>(after - frames_.begin() - 1);
  }

  Enactment enactment_;
  Duration half_refresh_;
  std::vector<KeptFrame> frames_;
  Duration frame_length_;
};

}  // namespace

std::unique_ptr<FrameSource> natural_talker(const Enactment& enactment,
                                            std::size_t lines,
                                            Hertz drawing_rate,
                                            const Checkpoint& checkpoint) {
  return std::make_unique<NaturalTalker>(enactment, lines, drawing_rate, checkpoint);
}

}  // namespace bimodal::runner
