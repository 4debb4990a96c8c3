#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "runner/session/cue_sheet.hpp"
#include "stimuli/picture/image.hpp"

namespace bimodal::runner {

/// A visual talker saying one item: the seam behind which the synthetic face, natural video and
/// image-based talkers look alike. Belongs to the thread that made it.
class FrameSource {
 public:
  FrameSource() = default;
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;
  FrameSource(FrameSource&&) = delete;
  FrameSource& operator=(FrameSource&&) = delete;
  virtual ~FrameSource() = default;

  /// The number of the picture that is seen at `time` since the recording's time zero, 0 <= time <=
  /// its length: times of equal numbers look alike, and are drawn once.
  [[nodiscard]] virtual std::int64_t picture_at(Duration time) = 0;

  /// Draws what is seen at `time`.
  [[nodiscard]] virtual std::shared_ptr<const Image> paint(Duration time) = 0;

  /// The frame of the media file that picture `number` is; absent for a talker without a file.
  [[nodiscard]] virtual std::optional<std::int64_t> source_frame(std::int64_t /*number*/) const {
    return std::nullopt;
  }
};

/// A prepared sequence of frames. Equal pictures are there once.
struct Film {
  static constexpr std::size_t kBlank = static_cast<std::size_t>(-1);  ///< no picture

  std::vector<std::shared_ptr<const Image>> pictures;
  std::vector<std::size_t> picture_of_frame;  ///< index into pictures, or kBlank
  /// Parallel to pictures: the frame of the media file; empty for a talker without one.
  std::vector<std::int64_t> source_frame_of_picture;
};

/// Called between pieces of long work; may block for as long as the work is to rest.
using Checkpoint = std::function<void()>;

/// How a film ends before its stimulus does.
struct Cut {
  Duration at{};      ///< on the recording's time
  bool blank = true;  ///< nothing is seen from there on; else the picture freezes
};

/// Draws every frame of a stimulus at `drawing_rate`. Before the recording stands its first
/// picture, after it the last.
[[nodiscard]] Film make_film(const StimulusLayout& layout,
                             Hertz drawing_rate,
                             FrameSource& source,
                             const Checkpoint& checkpoint,
                             const std::optional<Cut>& cut = std::nullopt);

}  // namespace bimodal::runner
