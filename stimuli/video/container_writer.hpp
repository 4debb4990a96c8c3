#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "stimuli/base/draft.hpp"
#include "stimuli/video/libav.hpp"

namespace bimodal::libav {

/// A media file that is being written, by FFmpeg's muxers: tracks are added, then it is begun, then
/// they are filled, then it is finished. The same packets give the same bytes.
class ContainerWriter {
 public:
  /// `muxer` by FFmpeg's name. The file appears when finish() is done. Throws Error as judge().
  ContainerWriter(const std::filesystem::path& file, std::string_view muxer);

  /// An encoder with FFmpeg's name for it; throws Error if FFmpeg has been built without.
  [[nodiscard]] CodecContext encoder(const char* name) const;

  /// Opens the encoder, whose time base is that of its frames, and adds its track.
  AVStream& add_track(AVCodecContext& encoder);

  void begin();

  /// Precondition: begun. The packet is of that track; its times are the encoder's.
  void write(AVPacket& packet, const AVCodecContext& encoder, const AVStream& track);

  void finish();

  /// Throws Error, naming the file, with FFmpeg's words for a code below 0.
  void judge(int code) const;

  [[noreturn]] void refuse(std::string_view finding, std::string_view remedy) const;

 private:
  struct CloseFile {
    void operator()(AVFormatContext* format) const;
  };

  std::filesystem::path file_;
  Draft draft_;
  bool is_webm_;
  std::unique_ptr<AVFormatContext, CloseFile> format_;
};

/// One track of a file that is being written, and its encoder.
class EncodedTrack {
 public:
  /// The encoder is ready to be opened.
  EncodedTrack(ContainerWriter& container, CodecContext encoder);

  /// Encodes a frame; nullptr asks for what the encoder still holds, and ends the track.
  void encode(const AVFrame* frame);

  [[nodiscard]] const AVCodecContext& encoder() const { return *encoder_; }

 private:
  ContainerWriter& container_;
  CodecContext encoder_;
  AVStream& track_;  ///< owned by the container
  Packet packet_ = new_packet();
};

}  // namespace bimodal::libav
