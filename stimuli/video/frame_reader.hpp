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
  MediaSpan span;          ///< the first frame is the one seen at span.start; if the picture begins
                           ///< later than that, its first one
};

/// Decodes the frames of a stretch one after the other, each exactly once, in the order of
/// presentation (FFmpeg, two threads; deinterlacing by bwdif, rotation, scaling and the change to
/// square pixels and sRGB are done while decoding). Holds the frame that comes next and what the
/// decoder needs. Belongs to one thread.
///
/// Frame accuracy does not rest on the container's seeking: frames before the stretch are decoded
/// and dropped, from a key frame on whose time shows that it is early enough. A stretch that begins
/// in the first 4 s, or in a file that does not tell the time of every frame, is reached from the
/// beginning of the file.
///
/// Indexes: from the beginning of the file, frames are counted. After a seek the first one's index
/// is its rank among the times of all packets, which were looked through without decoding; or, if
/// the first minute of the file has frames at exactly equal distances, follows from its time and
/// the rate.
///
/// Colours: by the matrix and range that the stream names; by default BT.709 from 1280 pixels of
/// width or 577 of height on, else BT.601, both of limited range. Transparency is ignored. Refused
/// with a remedy: a size or pixel format that changes in mid-file, high dynamic range, a picture to
/// be shown mirrored or at a slant.
class FrameReader {
 public:
  /// Throws Error, naming the file, if it has no picture or the stretch is not within it: an end of
  /// up to 50 ms after that of the file is taken for the file's.
  FrameReader(const std::filesystem::path& file, const FrameOptions& options);
  ~FrameReader();
  FrameReader(FrameReader&&) noexcept;
  FrameReader& operator=(FrameReader&&) noexcept;
  FrameReader(const FrameReader&) = delete;
  FrameReader& operator=(const FrameReader&) = delete;

  /// The next frame; absent after the last one of the stretch, the one that is seen just before its
  /// end. Throws Error, saying when, if a frame is damaged or missing; what FFmpeg has patched up
  /// counts as damaged. The image of `reuse` lends its memory.
  [[nodiscard]] std::optional<VideoFrame> next(Image reuse = {});

  /// Size of every frame handed out.
  [[nodiscard]] std::size_t width() const;
  [[nodiscard]] std::size_t height() const;

 private:
  struct Decoder;
  std::unique_ptr<Decoder> decoder_;
};

}  // namespace bimodal
