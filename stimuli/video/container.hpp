#pragma once

#include <filesystem>
#include <optional>

#include "stimuli/video/bounded_input.hpp"
#include "stimuli/video/libav.hpp"

namespace bimodal::libav {

/// A media file, opened without trust: FFmpeg sees this one file and nothing else (a playlist
/// cannot open another, no protocol is allowed), and reads a bounded number of bytes and packets of
/// it.
class Container {
 public:
  /// Throws Error, naming the file, if it is no recording, has neither sound nor picture, is
  /// longer than kLongestMedia or larger than kMostPicturePixels.
  explicit Container(const std::filesystem::path& file);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  [[nodiscard]] AVFormatContext& format() const { return *format_; }

  /// The track to be seen and the one to be heard; null if there is none. The default one where
  /// the container names one, else the first; pictures of covers do not count.
  [[nodiscard]] AVStream* picture() const { return picture_; }

  [[nodiscard]] AVStream* sound() const { return sound_; }

  /// Packets of all tracks but `track` are no longer read.
  void read_only(const AVStream& track);

  /// The next packet of one of the two tracks; false at the end of what can be read.
  [[nodiscard]] bool read(AVPacket& packet);

  /// FFmpeg's reason why reading ended before the end of the file; absent if it did not.
  [[nodiscard]] const std::optional<std::string>& failure() const { return failure_; }

  /// Goes to a key frame of the track that, by the container's word, is not after `time` (on the
  /// file's clock). False if the container cannot.
  [[nodiscard]] bool seek(const AVStream& track, Duration time);

  /// The length that the file's header claims for the two tracks; absent if it claims none, or the
  /// claim may be about other tracks.
  [[nodiscard]] std::optional<Duration> claimed_length() const;

 private:
  std::filesystem::path file_;
  BoundedInput input_;
  FormatContext format_;
  AVStream* picture_ = nullptr;
  AVStream* sound_ = nullptr;
  std::int64_t packets_left_ = 0;
  std::optional<std::string> failure_;
};

}  // namespace bimodal::libav
