#include "analysis/report/print/drawing.hpp"

#include <string>

#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include "stimuli/base/error.hpp"

namespace bimodal::analysis {

namespace {

/// GLib's error of one call, thrown as ours.
class Failure {
 public:
  Failure() = default;
  Failure(const Failure&) = delete;
  Failure& operator=(const Failure&) = delete;
  Failure(Failure&&) = delete;
  Failure& operator=(Failure&&) = delete;

  ~Failure() { g_clear_error(&error_); }

  GError** place() { return &error_; }

  [[noreturn]] void raise(std::string_view deed) const {
    throw Error{fmt::format("{}: {}; use the SVG or HTML file instead",
                            deed,
                            error_ == nullptr ? "librsvg does not say why" : error_->message)};
  }

 private:
  GError* error_ = nullptr;
};

}  // namespace

void SvgDrawing::Release::operator()(_RsvgHandle* handle) const {
  g_object_unref(handle);
}

SvgDrawing::SvgDrawing(std::string_view svg) {
  Failure failure;
  handle_.reset(rsvg_handle_new_from_data(
      reinterpret_cast<const guint8*>(svg.data()), svg.size(), failure.place()));
  if (!handle_) failure.raise("reading a figure for the PDF");
  constexpr double kPixelsPerInch = 96.0;
  constexpr double kPointsPerPixel = 72.0 / kPixelsPerInch;
  rsvg_handle_set_dpi(handle_.get(), kPixelsPerInch);
  if (rsvg_handle_get_intrinsic_size_in_pixels(handle_.get(), &width_, &height_) == FALSE ||
      width_ <= 0.0 || height_ <= 0.0) {
    throw Error{"reading a figure for the PDF: it does not say its size; give it width and height"};
  }
  width_ *= kPointsPerPixel;
  height_ *= kPointsPerPixel;
}

void SvgDrawing::paint(cairo_t* context, const Box& place) const {
  Failure failure;
  const RsvgRectangle viewport{place.left, place.top, place.width, place.height};
  if (rsvg_handle_render_document(handle_.get(), context, &viewport, failure.place()) == FALSE) {
    failure.raise("drawing a figure into the PDF");
  }
}

}  // namespace bimodal::analysis
