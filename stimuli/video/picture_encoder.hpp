#pragma once

#include <cstdint>
#include <memory>

#include "stimuli/picture/image.hpp"
#include "stimuli/video/container_writer.hpp"
#include "stimuli/video/video_writer.hpp"

namespace bimodal::libav {

/// The track of pictures of a file that is being written. All pictures have the size that the
/// options say.
class PictureEncoder {
 public:
  PictureEncoder() = default;
  PictureEncoder(const PictureEncoder&) = delete;
  PictureEncoder& operator=(const PictureEncoder&) = delete;
  PictureEncoder(PictureEncoder&&) = delete;
  PictureEncoder& operator=(PictureEncoder&&) = delete;
  virtual ~PictureEncoder() = default;

  virtual void add(const Image& picture) = 0;
  virtual void finish() = 0;
};

/// H.264 (libx264; MPEG-4 part 2 where FFmpeg has none) for .mp4, VP9 (libvpx) for .webm: pixels of
/// 4:2:0, BT.709 with television's range of levels.
[[nodiscard]] std::unique_ptr<PictureEncoder> film_encoder(ContainerWriter& container,
                                                           const VideoForm& form,
                                                           const VideoOptions& options);

/// GIF: the 255 colours that serve all pictures best, so that a finished picture needs all of them;
/// until then they are kept (see most_frames). Ordered dither, which stands still where the
/// picture does.
[[nodiscard]] std::unique_ptr<PictureEncoder> palette_encoder(ContainerWriter& container,
                                                              const VideoForm& form,
                                                              const VideoOptions& options);

}  // namespace bimodal::libav
