#pragma once

#include <filesystem>

#include "stimuli/picture/image.hpp"
#include "stimuli/video/libav.hpp"
#include "stimuli/video/survey.hpp"

namespace bimodal::libav {

/// Decoded frames to upright pictures of square pixels and one size, RGBA, sRGB bytes.
///
/// swscale, bicubic, rounded accurately, colour differences interpolated. The colour matrix is the
/// one that the stream names; if it names none, BT.709 for pictures of 1280 x 577 and more in
/// either direction, else BT.601, as FFmpeg's players do. Transfer curve and primaries are taken as
/// they are (BT.601 and 709 differ little from sRGB in both); those of high dynamic range are
/// refused. Transparency is ignored.
class PictureConverter {
 public:
  /// `height` pixels after turning upright; 0: the video's own.
  PictureConverter(const std::filesystem::path& file, const Survey& survey, std::size_t height);

  /// Throws Error if the frame is of another size than the first one.
  [[nodiscard]] Image convert(const AVFrame& frame, Image reuse);

  [[nodiscard]] std::size_t width() const { return width_; }

  [[nodiscard]] std::size_t height() const { return height_; }

 private:
  void prepare_for(const AVFrame& frame);

  std::filesystem::path file_;
  int stored_width_;
  int stored_height_;
  int rotation_degrees_;
  std::size_t width_;
  std::size_t height_;
  Scaler scaler_;
  Frame scaled_;  ///< not yet upright
  int format_ = AV_PIX_FMT_NONE;
  int colour_space_ = AVCOL_SPC_UNSPECIFIED;
  int colour_range_ = AVCOL_RANGE_UNSPECIFIED;
};

}  // namespace bimodal::libav
