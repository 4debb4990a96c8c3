#include "stimuli/video/track_decoder.hpp"

#include <new>

#include <fmt/format.h>

#include "stimuli/video/media_file.hpp"

namespace bimodal::libav {

TrackDecoder::TrackDecoder(const std::filesystem::path& file, const AVStream& track, int threads) {
  const auto* codec = avcodec_find_decoder(track.codecpar->codec_id);
  if (codec == nullptr) {
    refuse("decode",
           file,
           fmt::format("FFmpeg has no decoder for its {} ('{}')",
                       track.codecpar->codec_type == AVMEDIA_TYPE_VIDEO ? "picture" : "sound",
                       avcodec_get_name(track.codecpar->codec_id)),
           "convert it, e.g. to H.264 and FLAC in a .mkv file");
  }
  context_.reset(avcodec_alloc_context3(codec));
  if (!context_) throw std::bad_alloc{};
  int outcome = avcodec_parameters_to_context(context_.get(), track.codecpar);
  context_->pkt_timebase = track.time_base;
  context_->thread_count = threads;
  context_->max_pixels = static_cast<std::int64_t>(kMostPicturePixels);
  if (outcome >= 0) outcome = avcodec_open2(context_.get(), codec, nullptr);
  if (outcome < 0) {
    refuse("decode",
           file,
           fmt::format("FFmpeg's decoder '{}' says \"{}\"", codec->name, words_of(outcome)),
           "convert it again");
  }
}

int TrackDecoder::push(const AVPacket* packet) {
  return avcodec_send_packet(context_.get(), packet);
}

int TrackDecoder::pull(AVFrame& frame) {
  return avcodec_receive_frame(context_.get(), &frame);
}

void TrackDecoder::restart() {
  avcodec_flush_buffers(context_.get());
}

TrackReader::TrackReader(Container& container, const AVStream& track, int threads)
    : container_{container}, track_{track}, decoder_{container.file(), track, threads} {}

void TrackReader::restart() {
  decoder_.restart();
  ended_ = false;
}

void TrackReader::give_up(const std::string& reason) const {
  refuse("decode",
         container_.file(),
         fmt::format("near {} it is damaged (FFmpeg says \"{}\")",
                     reached_ ? in_seconds(*reached_) : "its beginning",
                     reason),
         "copy or record it again, or take a stretch before that");
}

/// Hands the next packet of the track to the decoder; FFmpeg's code.
int TrackReader::feed() {
  while (container_.read(*packet_)) {
    if (packet_->stream_index != track_.index) continue;
    const auto stamp = packet_->pts != AV_NOPTS_VALUE ? packet_->pts : packet_->dts;
    if (const auto time = duration_of(stamp, track_.time_base)) reached_ = time;
    const bool torn = (packet_->flags & AV_PKT_FLAG_CORRUPT) != 0;
    const int outcome = decoder_.push(packet_.get());
    return torn && outcome >= 0 ? AVERROR_INVALIDDATA : outcome;
  }
  ended_ = true;
  const int outcome = decoder_.push(nullptr);
  return container_.failure() ? AVERROR_INVALIDDATA : outcome;
}

bool TrackReader::next(AVFrame& frame, bool damage_allowed) {
  while (true) {
    int outcome = decoder_.pull(frame);
    if (outcome == AVERROR_EOF) return false;
    if (outcome == AVERROR(EAGAIN)) {
      if (ended_) return false;
      outcome = feed();
      if (outcome >= 0 || damage_allowed) continue;
      give_up(container_.failure().value_or(words_of(outcome)));
    }
    if (outcome < 0) {
      if (!damage_allowed) give_up(words_of(outcome));
      continue;
    }
    const bool patched =
        frame.decode_error_flags != 0 || (frame.flags & AV_FRAME_FLAG_CORRUPT) != 0;
    if (!patched) return true;
    if (!damage_allowed) give_up("a part of the frame is missing");
  }
}

}  // namespace bimodal::libav
