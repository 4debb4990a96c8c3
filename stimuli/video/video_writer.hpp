#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "stimuli/audio/clip.hpp"
#include "stimuli/picture/image.hpp"
#include "stimuli/video/frame_rate.hpp"
#include "stimuli/video/video_form.hpp"

namespace bimodal {

struct VideoOptions {
  std::size_t width = 0;   ///< pixels, even; to 8192
  std::size_t height = 0;  ///< pixels, even; to 8192
  FrameRate rate;
  std::optional<int> rate_factor;  ///< absent: the form's usual one
  const Clip* sound = nullptr;     ///< begins with the first picture; borrowed by the constructor
};

/// Writes pictures, with sound if there is one, as a video (see video_forms()). Colours are BT.709,
/// as the file says. The same pictures and sound give the same bytes. It encodes on a thread of its
/// own, while the next picture is drawn.
class VideoWriter {
 public:
  /// The video appears as `file` when finish() is done. Throws Error, naming the file, if its name
  /// does not end as a video's, the size is not even or beyond 8192, the form cannot have a sound,
  /// this rate factor or this rate, it cannot be written there, or FFmpeg lacks the encoder.
  VideoWriter(const std::filesystem::path& file, const VideoOptions& options);
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;
  VideoWriter(VideoWriter&&) = delete;
  VideoWriter& operator=(VideoWriter&&) = delete;

  /// Precondition: a picture of the video's size. Throws Error if it or an earlier one cannot be
  /// encoded or written.
  void add(const Image& picture);

  /// Throws Error if the file cannot be completed. Nothing can be added afterwards.
  void finish();

 private:
  struct Tracks;
  std::unique_ptr<Tracks> tracks_;
};

}  // namespace bimodal
