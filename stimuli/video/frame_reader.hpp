#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "stimuli/picture/image.hpp"
#include "stimuli/video/media_file.hpp"
#include "stimuli/video/sound_track.hpp"

namespace bimodal {

/// One frame of a video and when it is seen.
struct VideoFrame {
  std::int64_t index = 0;  ///< from 0 in the order of presentation, over the whole file
  Duration start{};        ///< on the common zero of the file's tracks (MediaSpan)
  Duration end{};          ///< start of the next frame, or its own duration for the last
  Image image;             ///< upright, square pixels, deinterlaced
};

/// How frames are to be handed out.
struct FrameOptions {
  std::size_t height = 0;  ///< pixels; 0: the video's own; the width follows from its shape
  MediaSpan span;          ///< the first frame is the one seen at span.start
};

/// Decodes the frames of a stretch one after the other, each exactly once, in the order of
/// presentation (FFmpeg; deinterlacing, rotation, scaling and the change to square pixels and sRGB
/// are done while decoding). Holds one frame of its own and what the decoder needs. Frame
/// accuracy does not rest on the container's seeking: frames before the stretch are decoded and
/// dropped from the last key frame on. Belongs to one thread.
class FrameReader {
 public:
  /// Throws Error, naming the file, if it has no picture or the stretch is not within it.
  FrameReader(const std::filesystem::path& file, const FrameOptions& options);
  ~FrameReader();
  FrameReader(FrameReader&&) noexcept;
  FrameReader& operator=(FrameReader&&) noexcept;
  FrameReader(const FrameReader&) = delete;
  FrameReader& operator=(const FrameReader&) = delete;

  /// The next frame; absent after the last one of the stretch. Throws Error if it cannot be
  /// decoded. The image of `reuse` lends its memory.
  [[nodiscard]] std::optional<VideoFrame> next(Image reuse = {});

  /// Size of every frame handed out.
  [[nodiscard]] std::size_t width() const;
  [[nodiscard]] std::size_t height() const;

 private:
  struct Decoder;
  std::unique_ptr<Decoder> decoder_;
};

}  // namespace bimodal
