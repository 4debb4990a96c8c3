#pragma once

#include <epoxy/gl.h>

#include "synth/render/image.hpp"

namespace bimodal::synth {

/// Where a picture is drawn: sRGB colour and depth with 4 samples a pixel, and the plain picture
/// that they are averaged into (in linear light). Lives as long as the context that is current at
/// construction.
class PictureTarget {
 public:
  PictureTarget(std::size_t width, std::size_t height);

  /// What is drawn from now on goes into an empty picture.
  void begin() const;

  /// Averages the samples and copies them out; `image` keeps its memory.
  void read_into(Image& image) const;

 private:
  std::size_t width_;
  std::size_t height_;
  GLuint samples_ = 0;  // framebuffers
  GLuint picture_ = 0;
};

}  // namespace bimodal::synth
