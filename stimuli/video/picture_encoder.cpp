#include "stimuli/video/picture_encoder.hpp"

#include <array>
#include <new>
#include <string>
#include <utility>

extern "C" {
#include <libavutil/opt.h>
}

namespace bimodal::libav {

namespace {

constexpr int kMpeg4Quality = 2;  ///< of 31, the best

struct Setting {
  const char* name;
  const char* value;
};

/// Two threads code the rows of a picture; the bytes do not depend on them.
constexpr std::array kVp9Settings{
    Setting{"deadline", "good"}, Setting{"cpu-used", "3"}, Setting{"row-mt", "1"}};

CodecContext opened(const ContainerWriter& container,
                    const VideoForm& form,
                    const VideoOptions& options) {
  const bool is_webm = form.ending == ".webm";
  const bool has_x264 = avcodec_find_encoder_by_name("libx264") != nullptr;
  auto codec = container.encoder(is_webm ? "libvpx-vp9" : has_x264 ? "libx264" : "mpeg4");
  codec->width = static_cast<int>(options.width);
  codec->height = static_cast<int>(options.height);
  codec->framerate = {.num = static_cast<int>(options.rate.pictures),
                      .den = static_cast<int>(options.rate.seconds)};
  codec->time_base = av_inv_q(codec->framerate);
  codec->pix_fmt = AV_PIX_FMT_YUV420P;
  codec->colorspace = AVCOL_SPC_BT709;
  codec->color_primaries = AVCOL_PRI_BT709;
  codec->color_trc = AVCOL_TRC_BT709;
  codec->color_range = AVCOL_RANGE_MPEG;
  codec->thread_count = 1;  // the same bytes on every machine
  if (is_webm) {
    codec->thread_count = 2;
    codec->bit_rate = 0;  // as many bits as the quality needs
    for (const auto& [name, value] : kVp9Settings) {
      container.judge(av_opt_set(codec->priv_data, name, value, 0));
    }
  }
  if (!is_webm && !has_x264) {
    codec->flags |= AV_CODEC_FLAG_QSCALE;
    codec->global_quality = FF_QP2LAMBDA * kMpeg4Quality;
  } else {
    const auto factor = std::to_string(options.rate_factor.value_or(form.factor->usual));
    container.judge(av_opt_set(codec->priv_data, "crf", factor.c_str(), 0));
  }
  return codec;
}

class FilmEncoder final : public PictureEncoder {
 public:
  FilmEncoder(ContainerWriter& container, const VideoForm& form, const VideoOptions& options)
      : container_{container}, track_{container, opened(container, form, options)} {
    const auto& codec = track_.encoder();
    scaler_.reset(sws_getContext(codec.width,
                                 codec.height,
                                 AV_PIX_FMT_RGB0,
                                 codec.width,
                                 codec.height,
                                 codec.pix_fmt,
                                 SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP,
                                 nullptr,
                                 nullptr,
                                 nullptr));
    if (!scaler_) throw std::bad_alloc{};
    const auto* const matrix = sws_getCoefficients(SWS_CS_ITU709);
    constexpr int kUnity = 1 << 16;
    sws_setColorspaceDetails(scaler_.get(), matrix, 1, matrix, 0, 0, kUnity, kUnity);
    frame_->format = codec.pix_fmt;
    frame_->width = codec.width;
    frame_->height = codec.height;
    container.judge(av_frame_get_buffer(frame_.get(), 0));
  }

  void add(const Image& picture) override {
    container_.judge(av_frame_make_writable(frame_.get()));
    const std::array<const std::uint8_t*, 1> source{picture.pixels.data()};
    const std::array<int, 1> stride{static_cast<int>(picture.width * 4)};
    sws_scale(scaler_.get(),
              source.data(),
              stride.data(),
              0,
              frame_->height,
              frame_->data,
              frame_->linesize);
    frame_->pts = count_++;
    track_.encode(frame_.get());
  }

  void finish() override { track_.encode(nullptr); }

 private:
  ContainerWriter& container_;
  EncodedTrack track_;
  Scaler scaler_;
  Frame frame_ = new_frame();
  std::int64_t count_ = 0;
};

}  // namespace

std::unique_ptr<PictureEncoder> film_encoder(ContainerWriter& container,
                                             const VideoForm& form,
                                             const VideoOptions& options) {
  return std::make_unique<FilmEncoder>(container, form, options);
}

}  // namespace bimodal::libav
