#include "stimuli/video/container_writer.hpp"

#include <new>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace bimodal::libav {

void ContainerWriter::CloseFile::operator()(AVFormatContext* format) const {
  if (format->pb != nullptr) avio_closep(&format->pb);
  avformat_free_context(format);
}

ContainerWriter::ContainerWriter(const std::filesystem::path& file, std::string_view muxer)
    : file_{file}, draft_{file}, is_webm_{muxer == "webm"} {
  be_silent();
  AVFormatContext* format = nullptr;
  judge(avformat_alloc_output_context2(&format, nullptr, std::string{muxer}.c_str(), nullptr));
  format_.reset(format);
  format_->flags |= AVFMT_FLAG_BITEXACT;
  judge(avio_open(&format_->pb, draft_.path().c_str(), AVIO_FLAG_WRITE));
}

CodecContext ContainerWriter::encoder(const char* name) const {
  const auto* const found = avcodec_find_encoder_by_name(name);
  if (found == nullptr) {
    refuse(fmt::format("FFmpeg has no encoder {}", name), "install libavcodec59 of Debian");
  }
  CodecContext made{avcodec_alloc_context3(found)};
  if (!made) throw std::bad_alloc{};
  return made;
}

AVStream& ContainerWriter::add_track(AVCodecContext& encoder) {
  if ((format_->oformat->flags & AVFMT_GLOBALHEADER) != 0) {
    encoder.flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  }
  judge(avcodec_open2(&encoder, encoder.codec, nullptr));
  auto* const track = avformat_new_stream(format_.get(), nullptr);
  if (track == nullptr) throw std::bad_alloc{};
  judge(avcodec_parameters_from_context(track->codecpar, &encoder));
  track->time_base = encoder.time_base;
  if (encoder.codec_type == AVMEDIA_TYPE_VIDEO) track->avg_frame_rate = encoder.framerate;
  return *track;
}

void ContainerWriter::begin() {
  judge(avformat_write_header(format_.get(), nullptr));
}

void ContainerWriter::write(AVPacket& packet,
                            const AVCodecContext& encoder,
                            const AVStream& track) {
  if (is_webm_) {
    // Blocks of sound count from the beginning of the priming, which WebM calls the codec's delay.
    // FFmpeg 5.1 would make them begin before 0 and then move the pictures to 7 ms as well.
    packet.pts += encoder.initial_padding;
    packet.dts += encoder.initial_padding;
  }
  av_packet_rescale_ts(&packet, encoder.time_base, track.time_base);
  packet.stream_index = track.index;
  judge(av_interleaved_write_frame(format_.get(), &packet));
}

void ContainerWriter::finish() {
  judge(av_write_trailer(format_.get()));
  judge(avio_closep(&format_->pb));
  draft_.keep();
}

void ContainerWriter::judge(int code) const {
  if (code < 0) refuse(words_of(code), "is there room on the disk, and may you write there?");
}

void ContainerWriter::refuse(std::string_view finding, std::string_view remedy) const {
  libav::refuse("write", file_, finding, remedy);
}

EncodedTrack::EncodedTrack(ContainerWriter& container, CodecContext encoder)
    : container_{container}, encoder_{std::move(encoder)}, track_{container.add_track(*encoder_)} {}

void EncodedTrack::encode(const AVFrame* frame) {
  container_.judge(avcodec_send_frame(encoder_.get(), frame));
  for (;;) {
    const int code = avcodec_receive_packet(encoder_.get(), packet_.get());
    if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
    container_.judge(code);
    if (encoder_->codec_type == AVMEDIA_TYPE_VIDEO) packet_->duration = 1;
    container_.write(*packet_, *encoder_, track_);
  }
}

}  // namespace bimodal::libav
