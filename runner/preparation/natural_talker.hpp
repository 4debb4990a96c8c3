#pragma once

#include <memory>

#include "runner/preparation/enactment.hpp"
#include "runner/preparation/frame_source.hpp"

namespace bimodal::runner {

/// The most memory that the frames of one item may take: 1 GiB, 10 s at 720 lines and 25 frames/s
/// being a quarter of it.
inline constexpr std::size_t kMostFrameBytes = std::size_t{1} << 30U;

/// The video of an enactment, decoded whole before it is shown. A refresh shows the frame
/// that is on at its middle, the last whose presentation time is not after it, so that frames begin
/// at most half a refresh off their time. Slower than recorded, frames stay longer. Faster, the
/// frame rate stays that of the recording: at rate 3 every third frame is shown, each as long as
/// before; at 1.5, of three frames two. Throws Error, naming the file, if it cannot be decoded, or
/// its frames do not fit into kMostFrameBytes.
[[nodiscard]] std::unique_ptr<FrameSource> natural_talker(const Enactment& enactment,
                                                          std::size_t lines,
                                                          Hertz drawing_rate,
                                                          const Checkpoint& checkpoint);

}  // namespace bimodal::runner
