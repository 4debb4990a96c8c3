#include "stimuli/video/picture_converter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <new>
#include <utility>

#include <fmt/format.h>

extern "C" {
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
}

namespace bimodal::libav {

namespace {

constexpr int kThreads = 2;
constexpr int kFlags = SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT | SWS_FULL_CHR_H_INP;
constexpr int kUnity = 1 << 16;  ///< contrast and saturation of swscale

int matrix_of(const AVFrame& frame) {
  switch (number_in(frame.colorspace)) {
    case AVCOL_SPC_BT709:
      return SWS_CS_ITU709;
    case AVCOL_SPC_FCC:
      return SWS_CS_FCC;
    case AVCOL_SPC_BT470BG:
    case AVCOL_SPC_SMPTE170M:
      return SWS_CS_ITU601;
    case AVCOL_SPC_SMPTE240M:
      return SWS_CS_SMPTE240M;
    case AVCOL_SPC_BT2020_NCL:
    case AVCOL_SPC_BT2020_CL:
      return SWS_CS_BT2020;
    default:
      break;
  }
  constexpr int kWide = 1280;
  constexpr int kHigh = 576;
  return frame.width >= kWide || frame.height > kHigh ? SWS_CS_ITU709 : SWS_CS_ITU601;
}

void require_plain_range(const AVFrame& frame, const std::filesystem::path& file) {
  const int curve = number_in(frame.color_trc);
  if (curve != AVCOL_TRC_SMPTE2084 && curve != AVCOL_TRC_ARIB_STD_B67) return;
  refuse("show",
         file,
         "it is of high dynamic range (HDR), which would look washed out",
         "convert it to the common range, e.g. by 'ffmpeg -i IN -vf zscale=t=linear,tonemap,"
         "zscale=t=bt709:m=bt709:r=tv,format=yuv420p OUT'");
}

/// Turns clockwise and gathers the three planes. Every target row is a row or a column of the
/// source, forwards or backwards.
void turn(const AVFrame& scaled, int degrees, Image& image) {
  const auto stride = static_cast<std::ptrdiff_t>(scaled.linesize[0]);  // equal in all planes
  const auto last_row = (static_cast<std::ptrdiff_t>(scaled.height) - 1) * stride;
  const auto last_column = static_cast<std::ptrdiff_t>(scaled.width) - 1;
  std::ptrdiff_t corner = 0;  // what becomes the upper left pixel
  std::ptrdiff_t right = 1;   // where its right neighbour was
  std::ptrdiff_t down = stride;
  if (degrees == 90) {
    corner = last_row;
    right = -stride;
    down = 1;
  } else if (degrees == 180) {
    corner = last_row + last_column;
    right = -1;
    down = -stride;
  } else if (degrees == 270) {
    corner = last_column;
    right = stride;
    down = -1;
  }
  const auto width = static_cast<std::ptrdiff_t>(image.width);
  const auto gather = [&](std::uint8_t* target, std::ptrdiff_t row, std::ptrdiff_t step) {
    const auto* green = scaled.data[0] + row;
    const auto* blue = scaled.data[1] + row;
    const auto* red = scaled.data[2] + row;
    for (std::ptrdiff_t x = 0; x < width; ++x) {
      target[4 * x] = red[x * step];
      target[4 * x + 1] = green[x * step];
      target[4 * x + 2] = blue[x * step];
      target[4 * x + 3] = 255;
    }
  };
  auto* target = image.pixels.data();
  for (std::size_t y = 0; y < image.height; ++y) {
    const auto row = corner + static_cast<std::ptrdiff_t>(y) * down;
    if (right == 1) {
      gather(target, row, 1);  // a constant, so that the compiler reads whole vectors
    } else {
      gather(target, row, right);
    }
    target += image.width * 4;
  }
}

}  // namespace

PictureConverter::PictureConverter(const std::filesystem::path& file,
                                   const Survey& survey,
                                   std::size_t height)
    : file_{file},
      stored_width_{static_cast<int>(survey.media.picture->stored_width)},
      stored_height_{static_cast<int>(survey.media.picture->stored_height)},
      rotation_degrees_{survey.media.picture->rotation_degrees},
      width_{survey.media.picture->width},
      height_{survey.media.picture->height} {
  if (height == 0) return;
  // From the stored size: the width as shown is already rounded.
  double shape = static_cast<double>(stored_width_) * av_q2d(survey.pixel_aspect) /
                 static_cast<double>(stored_height_);
  if (rotation_degrees_ % 180 != 0) shape = 1.0 / shape;
  const double width = std::max(std::round(static_cast<double>(height) * shape), 1.0);
  if (!(width * static_cast<double>(height) <= static_cast<double>(kMostPicturePixels))) {
    refuse("show",
           file,
           fmt::format("at a height of {} it would be {} pixels wide", height, width),
           "choose a smaller height");
  }
  width_ = static_cast<std::size_t>(width);
  height_ = height;
}

void PictureConverter::prepare_for(const AVFrame& frame) {
  if (frame.width != stored_width_ || frame.height != stored_height_) {
    refuse("show",
           file_,
           fmt::format("its picture changes from {} x {} to {} x {} pixels",
                       stored_width_,
                       stored_height_,
                       frame.width,
                       frame.height),
           "cut it there, or bring it to one size, e.g. by 'ffmpeg -i IN OUT'");
  }
  const int colour_space = number_in(frame.colorspace);
  const int colour_range = number_in(frame.color_range);
  if (scaler_ && frame.format == format_ && colour_space == colour_space_ &&
      colour_range == colour_range_) {
    return;
  }
  require_plain_range(frame, file_);
  format_ = frame.format;
  colour_space_ = colour_space;
  colour_range_ = colour_range;
  const bool lying = rotation_degrees_ % 180 != 0;
  scaled_ = new_frame();
  // Into planes, swscale has vector code for the same sums: four times as fast as into RGBA.
  scaled_->format = AV_PIX_FMT_GBRP;
  scaled_->width = static_cast<int>(lying ? height_ : width_);
  scaled_->height = static_cast<int>(lying ? width_ : height_);
  if (av_frame_get_buffer(scaled_.get(), 0) < 0) throw std::bad_alloc{};

  scaler_.reset(sws_alloc_context());
  if (!scaler_) throw std::bad_alloc{};
  const auto set = [this](const char* name, int value) {
    av_opt_set_int(scaler_.get(), name, value, 0);
  };
  set("srcw", frame.width);
  set("srch", frame.height);
  set("src_format", frame.format);
  set("dstw", scaled_->width);
  set("dsth", scaled_->height);
  set("dst_format", scaled_->format);
  set("sws_flags", kFlags);
  set("threads", kThreads);
  const auto format = static_cast<AVPixelFormat>(frame.format);
  const auto* name = av_get_pix_fmt_name(format);
  int outcome = sws_isSupportedInput(format) != 0 ? 0 : AVERROR(ENOSYS);
  if (outcome >= 0) outcome = sws_init_context(scaler_.get(), nullptr, nullptr);
  if (outcome < 0) {
    refuse("show",
           file_,
           fmt::format("its pixel format '{}' cannot be converted", name != nullptr ? name : "?"),
           "convert it, e.g. by 'ffmpeg -i IN -pix_fmt yuv420p OUT'");
  }
  const auto* matrix = sws_getCoefficients(matrix_of(frame));
  constexpr int kFull = 1;
  const int range = colour_range == AVCOL_RANGE_JPEG ? kFull : 0;
  // RGB has no matrix, and FFmpeg says so by an error.
  (void)sws_setColorspaceDetails(scaler_.get(), matrix, range, matrix, kFull, 0, kUnity, kUnity);
}

Image PictureConverter::convert(const AVFrame& frame, Image reuse) {
  prepare_for(frame);
  const int outcome = sws_scale_frame(scaler_.get(), scaled_.get(), &frame);
  if (outcome < 0) {
    refuse("show",
           file_,
           fmt::format("FFmpeg cannot scale it (\"{}\")", words_of(outcome)),
           "convert it, e.g. by 'ffmpeg -i IN -pix_fmt yuv420p OUT'");
  }
  Image image = std::move(reuse);
  image.width = width_;
  image.height = height_;
  image.pixels.resize(width_ * height_ * 4);
  turn(*scaled_, rotation_degrees_, image);
  return image;
}

}  // namespace bimodal::libav
