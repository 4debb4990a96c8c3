#pragma once

#include <epoxy/gl.h>

#include "stimuli/picture/image.hpp"
#include "synth/render/edge_smoothing.hpp"

namespace bimodal::synth {

/// Where a picture is drawn: sRGB colour, depth and stencil. Lives as long as the context that is
/// current at construction.
class PictureTarget {
 public:
  /// With several samples a pixel nothing is smoothed afterwards. Throws Error if OpenGL cannot
  /// draw pictures of that size.
  PictureTarget(std::size_t width, std::size_t height, int samples);

  /// What is drawn from now on until begin() is what every picture begins with, instead of nothing.
  void begin_ground();

  /// What is drawn from now on goes into a new picture.
  void begin() const;

  /// Copies the picture out, its edges smoothed; `image` keeps its memory.
  void read_into(Image& image);

 private:
  GLuint framebuffer_ = 0;  // where one draws
  GLuint ground_ = 0;       // what every picture begins with; 0: nothing
  GLuint single_ = 0;       // where pixels are read; the same with one sample
  int samples_;
  Image raw_;
  EdgeSmoothing smoothing_;
};

}  // namespace bimodal::synth
