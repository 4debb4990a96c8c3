#pragma once

#include <filesystem>
#include <memory>

#include "stimuli/base/quantity.hpp"
#include "stimuli/picture/image.hpp"

namespace bimodal {

/// Writes pictures as a silent MP4 video: H.264 (by libx264, constant quality 16, BT.709) in pixels
/// of 4:2:0, which every player knows; MPEG-4 part 2 where FFmpeg has no libx264. The same pictures
/// give the same bytes.
class VideoWriter {
 public:
  /// The video appears as `file` when finish() is done. Throws Error, naming the file, if its name
  /// does not end with .mp4, the size is not even or beyond 8192, or no encoder is there.
  VideoWriter(const std::filesystem::path& file, std::size_t width, std::size_t height, Hertz rate);
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;
  VideoWriter(VideoWriter&&) = delete;
  VideoWriter& operator=(VideoWriter&&) = delete;

  /// Precondition: a picture of the video's size. Throws Error if it cannot be encoded or written.
  void add(const Image& picture);

  /// Throws Error if the file cannot be completed. Nothing can be added afterwards.
  void finish();

 private:
  struct Encoding;
  std::unique_ptr<Encoding> encoding_;
};

}  // namespace bimodal
