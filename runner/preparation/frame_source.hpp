#pragma once

#include <cstdint>
#include <functional>
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

  /// Draws what is seen at `time` since the recording's time zero, 0 <= time <= its length.
  virtual void paint(Duration time, Image& image) = 0;
};

/// A prepared sequence of frames. Still parts share one picture.
struct Film {
  std::vector<Image> pictures;
  std::vector<std::size_t> picture_of_frame;
};

/// Called between pieces of long work; may block for as long as the work is to rest.
using Checkpoint = std::function<void()>;

/// Draws every frame of a stimulus at `drawing_rate`. Before the recording stands its first
/// picture, after it the last.
[[nodiscard]] Film make_film(const StimulusLayout& layout,
                             Hertz drawing_rate,
                             FrameSource& source,
                             const Checkpoint& checkpoint);

}  // namespace bimodal::runner
