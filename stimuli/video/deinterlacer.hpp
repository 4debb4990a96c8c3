#pragma once

#include <filesystem>

#include "stimuli/video/libav.hpp"

namespace bimodal::libav {

/// Makes whole pictures of interlaced frames: bwdif (FFmpeg), one picture a frame, which keeps the
/// lines of the first field in time and predicts the others from the fields around. Frames that are
/// not interlaced pass unchanged. As many come out as go in, in order, one frame late.
class Deinterlacer {
 public:
  /// For frames like this one.
  Deinterlacer(const std::filesystem::path& file, const AVFrame& like, AVRational unit);

  /// Takes over what the frame refers to; null: there are no more.
  void push(AVFrame* frame);

  /// False if another is needed first, or after the last one.
  [[nodiscard]] bool pull(AVFrame& frame);

 private:
  std::filesystem::path file_;
  FilterGraph graph_;
  AVFilterContext* source_ = nullptr;
  AVFilterContext* sink_ = nullptr;
};

}  // namespace bimodal::libav
