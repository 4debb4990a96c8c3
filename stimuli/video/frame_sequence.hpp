#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "stimuli/video/container.hpp"
#include "stimuli/video/libav.hpp"
#include "stimuli/video/survey.hpp"
#include "stimuli/video/track_decoder.hpp"

namespace bimodal::libav {

/// A decoded frame, when it is seen (on the common zero), and how many frames come before it.
struct Decoded {
  Frame frame;
  std::int64_t index = 0;
  Duration start{};
  Duration length{};  ///< its own, by the container's word
};

/// The frames of the picture track in the order of presentation, from the first frame or from a key
/// frame at or before a given time on. From the beginning they are counted; after a seek, the first
/// one's number follows from its time: by the rate where frames are regular, else by its rank among
/// the times of all packets. Where neither can be trusted there is no seek.
class FrameSequence {
 public:
  /// The survey must be of the same file and outlive the sequence.
  FrameSequence(const std::filesystem::path& file, const Survey& survey, Duration start);

  /// Absent after the last one. Throws Error if the next cannot be decoded, begins before the one
  /// before it, or is of another size or pixel format than it.
  [[nodiscard]] std::optional<Decoded> next();

  /// Of the frames' own time stamps.
  [[nodiscard]] AVRational unit() const;

 private:
  void open();
  [[nodiscard]] bool find(Duration start);
  [[nodiscard]] std::optional<Duration> time_of(const AVFrame& frame) const;
  [[nodiscard]] std::optional<std::int64_t> number_of(Duration time) const;
  [[nodiscard]] Decoded timed(Frame frame);
  void require_like_before(const AVFrame& frame, Duration time);

  std::filesystem::path file_;
  const Survey& survey_;
  std::optional<Container> container_;
  std::optional<TrackReader> reader_;
  std::optional<Decoded> found_;  ///< the frame at which a search ended
  std::int64_t next_index_ = 0;
  Duration next_start_{};
  Duration latest_ = Duration::min();
  int width_ = 0;
  int height_ = 0;
  int format_ = AV_PIX_FMT_NONE;
};

}  // namespace bimodal::libav
