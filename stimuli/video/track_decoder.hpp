#pragma once

#include <filesystem>
#include <optional>

#include "stimuli/video/container.hpp"
#include "stimuli/video/libav.hpp"

namespace bimodal::libav {

/// FFmpeg's decoder of one track. Samples that the container declares as priming or padding do not
/// come out of it, and the time stamps are those of the samples that do.
class TrackDecoder {
 public:
  /// Throws Error, naming the file, if FFmpeg has no decoder for the track.
  TrackDecoder(const std::filesystem::path& file, const AVStream& track, int threads);

  /// One packet of the track; null: there are no more. FFmpeg's code: 0, or why it was refused.
  [[nodiscard]] int push(const AVPacket* packet);

  /// FFmpeg's code: 0, AVERROR(EAGAIN) if it needs another packet, AVERROR_EOF after the last.
  [[nodiscard]] int pull(AVFrame& frame);

  /// Forgets everything, as after a seek.
  void restart();

  [[nodiscard]] const AVCodec& codec() const { return *context_->codec; }

 private:
  CodecContext context_;
};

/// The frames of one track of a container, one after the other.
class TrackReader {
 public:
  /// Neither is owned.
  TrackReader(Container& container, const AVStream& track, int threads);

  /// The next frame; false after the last one. Throws Error, saying at which time, if it cannot be
  /// decoded: unless `damage_allowed`, when what is damaged is left out.
  [[nodiscard]] bool next(AVFrame& frame, bool damage_allowed = false);

  /// After a seek of the container.
  void restart();

 private:
  [[noreturn]] void give_up(const std::string& reason) const;
  [[nodiscard]] int feed();

  Container& container_;
  const AVStream& track_;
  TrackDecoder decoder_;
  Packet packet_ = new_packet();
  std::optional<Duration> reached_;  ///< on the file's clock: the last packet's time
  bool ended_ = false;
};

}  // namespace bimodal::libav
