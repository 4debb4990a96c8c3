#pragma once

#include <memory>
#include <string_view>

#include <cairo.h>

#include "analysis/report/figures/svg.hpp"

struct _RsvgHandle;

namespace bimodal::analysis {

/// An SVG document, ready to be drawn by librsvg.
class SvgDrawing {
 public:
  /// Throws Error if it is no SVG or does not say its size.
  explicit SvgDrawing(std::string_view svg);

  /// As it says itself, in points.
  [[nodiscard]] double width() const { return width_; }

  [[nodiscard]] double height() const { return height_; }

  /// Scales it into the box, in points. Throws Error if it cannot be drawn.
  void paint(cairo_t* context, const Box& place) const;

 private:
  struct Release {
    void operator()(_RsvgHandle* handle) const;
  };

  std::unique_ptr<_RsvgHandle, Release> handle_;
  double width_ = 0.0;
  double height_ = 0.0;
};

}  // namespace bimodal::analysis
