#include "stimuli/video/video_writer.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/video/libav.hpp"

extern "C" {
#include <libavutil/opt.h>
}

namespace bimodal {

namespace {

constexpr std::size_t kLargestSide = 8192;
constexpr const char* kQuality = "16";  ///< libx264's constant rate factor
constexpr int kMpeg4Quality = 2;        ///< of 31, the best

struct CloseFile {
  void operator()(AVFormatContext* format) const {
    if (format->pb != nullptr) avio_closep(&format->pb);
    avformat_free_context(format);
  }
};

}  // namespace

struct VideoWriter::Encoding {
  std::filesystem::path file;
  Draft draft;
  std::unique_ptr<AVFormatContext, CloseFile> format;
  libav::CodecContext codec;
  libav::Frame frame = libav::new_frame();
  libav::Packet packet = libav::new_packet();
  libav::Scaler scaler;
  AVStream* stream = nullptr;  ///< owned by the format
  std::int64_t count = 0;

  explicit Encoding(const std::filesystem::path& target) : file{target}, draft{target} {}

  [[noreturn]] void refuse(std::string_view finding, std::string_view remedy) const {
    libav::refuse("write", file, finding, remedy);
  }

  void judge(int code) const {
    if (code < 0)
      refuse(libav::words_of(code), "is there room on the disk, and may you write there?");
  }

  void open_codec(std::size_t width, std::size_t height, Hertz rate) {
    const auto* encoder = avcodec_find_encoder_by_name("libx264");
    const bool is_x264 = encoder != nullptr;
    if (!is_x264) encoder = avcodec_find_encoder(AV_CODEC_ID_MPEG4);
    if (encoder == nullptr) {
      refuse("FFmpeg has neither libx264 nor an MPEG-4 encoder", "install libavcodec59 of Debian");
    }
    codec.reset(avcodec_alloc_context3(encoder));
    if (!codec) throw std::bad_alloc{};
    const AVRational frames = av_d2q(rate.count(), 1'000'000);
    codec->width = static_cast<int>(width);
    codec->height = static_cast<int>(height);
    codec->time_base = av_inv_q(frames);
    codec->framerate = frames;
    codec->pix_fmt = AV_PIX_FMT_YUV420P;
    codec->colorspace = AVCOL_SPC_BT709;
    codec->color_primaries = AVCOL_PRI_BT709;
    codec->color_trc = AVCOL_TRC_BT709;
    codec->color_range = AVCOL_RANGE_MPEG;
    codec->thread_count = 1;  // the same bytes on every machine
    if (is_x264) {
      judge(av_opt_set(codec->priv_data, "crf", kQuality, 0));
    } else {
      codec->flags |= AV_CODEC_FLAG_QSCALE;
      codec->global_quality = FF_QP2LAMBDA * kMpeg4Quality;
    }
    if ((format->oformat->flags & AVFMT_GLOBALHEADER) != 0) {
      codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    }
    judge(avcodec_open2(codec.get(), encoder, nullptr));
  }

  void open_file() {
    stream = avformat_new_stream(format.get(), nullptr);
    if (stream == nullptr) throw std::bad_alloc{};
    judge(avcodec_parameters_from_context(stream->codecpar, codec.get()));
    stream->time_base = codec->time_base;
    stream->avg_frame_rate = codec->framerate;
    judge(avio_open(&format->pb, draft.path().c_str(), AVIO_FLAG_WRITE));
    format->flags |= AVFMT_FLAG_BITEXACT;
    judge(avformat_write_header(format.get(), nullptr));
  }

  void open_scaler() {
    scaler.reset(sws_getContext(codec->width,
                                codec->height,
                                AV_PIX_FMT_RGB0,
                                codec->width,
                                codec->height,
                                AV_PIX_FMT_YUV420P,
                                SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP,
                                nullptr,
                                nullptr,
                                nullptr));
    if (!scaler) throw std::bad_alloc{};
    const auto* const matrix = sws_getCoefficients(SWS_CS_ITU709);
    constexpr int kUnity = 1 << 16;
    sws_setColorspaceDetails(scaler.get(), matrix, 1, matrix, 0, 0, kUnity, kUnity);
    frame->format = AV_PIX_FMT_YUV420P;
    frame->width = codec->width;
    frame->height = codec->height;
    judge(av_frame_get_buffer(frame.get(), 0));
  }

  /// A null frame asks for what the encoder still holds.
  void encode(const AVFrame* given) {
    judge(avcodec_send_frame(codec.get(), given));
    for (;;) {
      const int code = avcodec_receive_packet(codec.get(), packet.get());
      if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
      judge(code);
      packet->duration = 1;
      av_packet_rescale_ts(packet.get(), codec->time_base, stream->time_base);
      packet->stream_index = stream->index;
      judge(av_interleaved_write_frame(format.get(), packet.get()));
    }
  }
};

VideoWriter::VideoWriter(const std::filesystem::path& file,
                         std::size_t width,
                         std::size_t height,
                         Hertz rate)
    : encoding_{std::make_unique<Encoding>(file)} {
  assert(rate.count() > 0);
  libav::be_silent();
  if (file.extension() != ".mp4") {
    encoding_->refuse("videos are written as .mp4", "end its name so");
  }
  const bool is_usable = width > 0 && height > 0 && width % 2 == 0 && height % 2 == 0 &&
                         std::max(width, height) <= kLargestSide;
  if (!is_usable) {
    encoding_->refuse(fmt::format("{} x {} pixels are no size for this format", width, height),
                      fmt::format("give even numbers up to {}", kLargestSide));
  }
  AVFormatContext* format = nullptr;
  encoding_->judge(avformat_alloc_output_context2(&format, nullptr, "mp4", nullptr));
  encoding_->format.reset(format);
  encoding_->open_codec(width, height, rate);
  encoding_->open_file();
  encoding_->open_scaler();
}

VideoWriter::~VideoWriter() = default;

void VideoWriter::add(const Image& picture) {
  auto& encoding = *encoding_;
  auto& frame = *encoding.frame;
  assert(picture.width == static_cast<std::size_t>(frame.width));
  assert(picture.height == static_cast<std::size_t>(frame.height));
  encoding.judge(av_frame_make_writable(&frame));
  const std::array<const std::uint8_t*, 1> source{picture.pixels.data()};
  const std::array<int, 1> stride{static_cast<int>(picture.width * 4)};
  sws_scale(encoding.scaler.get(),
            source.data(),
            stride.data(),
            0,
            frame.height,
            frame.data,
            frame.linesize);
  frame.pts = encoding.count++;
  encoding.encode(&frame);
}

void VideoWriter::finish() {
  auto& encoding = *encoding_;
  encoding.encode(nullptr);
  encoding.judge(av_write_trailer(encoding.format.get()));
  encoding.format.reset();
  encoding.draft.keep();
}

}  // namespace bimodal
