#include "stimuli/figures/canvas.hpp"

#include <numbers>
#include <vector>

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal {

namespace {

constexpr double kPixelsAPoint = 2;

cairo_status_t append(void* target, const unsigned char* bytes, unsigned int count) {
  // Cairo's interface hands bytes over as unsigned characters.
  static_cast<std::string*>(target)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* surface(Canvas::Kind kind, FigureSize size, std::string& bytes) {
  switch (kind) {
    case Canvas::Kind::Svg:
      return cairo_svg_surface_create_for_stream(append, &bytes, size.width, size.height);
    case Canvas::Kind::Pdf: {
      auto* const made =
          cairo_pdf_surface_create_for_stream(append, &bytes, size.width, size.height);
      // No time of making, so that the same figure gives the same bytes.
      cairo_pdf_surface_set_metadata(made, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00");
      return made;
    }
    case Canvas::Kind::Png:
      break;
  }
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                    static_cast<int>(size.width * kPixelsAPoint),
                                    static_cast<int>(size.height * kPixelsAPoint));
}

}  // namespace

struct Canvas::Page {
  Kind kind;
  std::string bytes;
  cairo_surface_t* surface;
  cairo_t* cairo;

  Page(Kind which, FigureSize size)
      : kind{which}, surface{bimodal::surface(which, size, bytes)}, cairo{cairo_create(surface)} {
    if (kind == Kind::Png) cairo_scale(cairo, kPixelsAPoint, kPixelsAPoint);
    cairo_set_source_rgb(cairo, 1, 1, 1);
    cairo_paint(cairo);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  }

  ~Page() {
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
  }

  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;
  Page(Page&&) = delete;
  Page& operator=(Page&&) = delete;

  void ink(FigureColour colour) const {
    const auto part = [&](unsigned shift) {
      return static_cast<double>((colour >> shift) & 0xFFU) / 255;
    };
    cairo_set_source_rgb(cairo, part(16), part(8), part(0));
  }

  void font(double size, bool is_bold) const {
    cairo_select_font_face(cairo,
                           "DejaVu Sans",
                           CAIRO_FONT_SLANT_NORMAL,
                           is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, size);
  }

  [[nodiscard]] double advance(const std::string& text) const {
    cairo_text_extents_t extents{};
    cairo_text_extents(cairo, text.c_str(), &extents);
    return extents.x_advance;
  }
};

namespace {

/// Cairo stops for good at bytes that are not UTF-8.
std::string drawable(std::string_view text) {
  return is_utf8(text) ? std::string{text} : std::string(text.size(), '?');
}

}  // namespace

Canvas::Canvas(Kind kind, FigureSize size) : page_{std::make_unique<Page>(kind, size)} {}

Canvas::~Canvas() = default;

void Canvas::path(std::span<const PlotPoint> points,
                  FigureColour colour,
                  double width,
                  Stroke stroke) {
  if (points.empty()) return;
  auto* const cairo = page_->cairo;
  page_->ink(colour);
  cairo_set_line_width(cairo, width);
  const std::vector<double> dashes = stroke == Stroke::Dashed   ? std::vector{6.0, 3.0}
                                     : stroke == Stroke::Dotted ? std::vector{1.5, 2.5}
                                                                : std::vector<double>{};
  cairo_set_dash(cairo, dashes.data(), static_cast<int>(dashes.size()), 0);
  cairo_move_to(cairo, points.front().x, points.front().y);
  for (const auto& point : points.subspan(1)) cairo_line_to(cairo, point.x, point.y);
  cairo_stroke(cairo);
}

void Canvas::circle(PlotPoint centre, double radius, FigureColour colour, bool is_filled) {
  auto* const cairo = page_->cairo;
  page_->ink(colour);
  cairo_set_dash(cairo, nullptr, 0, 0);
  cairo_set_line_width(cairo, 1.2);
  cairo_new_sub_path(cairo);
  cairo_arc(cairo, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
  if (is_filled) {
    cairo_fill(cairo);
  } else {
    cairo_stroke(cairo);
  }
}

void Canvas::box(PlotPoint corner, FigureSize size, FigureColour colour) {
  page_->ink(colour);
  cairo_rectangle(page_->cairo, corner.x, corner.y, size.width, size.height);
  cairo_fill(page_->cairo);
}

void Canvas::words(std::string_view text, PlotPoint at, double size, Align align, bool is_bold) {
  const auto shown = drawable(text);
  page_->ink(0x202020);
  page_->font(size, is_bold);
  const double width = page_->advance(shown);
  const double left = align == Align::Left     ? at.x
                      : align == Align::Centre ? at.x - width / 2
                                               : at.x - width;
  cairo_move_to(page_->cairo, left, at.y);
  cairo_show_text(page_->cairo, shown.c_str());
}

void Canvas::words_upwards(std::string_view text, PlotPoint at, double size) {
  auto* const cairo = page_->cairo;
  const auto shown = drawable(text);
  page_->ink(0x202020);
  page_->font(size, false);
  cairo_save(cairo);
  cairo_translate(cairo, at.x, at.y);
  cairo_rotate(cairo, -std::numbers::pi / 2);
  cairo_move_to(cairo, -page_->advance(shown) / 2, 0);
  cairo_show_text(cairo, shown.c_str());
  cairo_restore(cairo);
}

double Canvas::width_of(std::string_view text, double size) const {
  page_->font(size, false);
  return page_->advance(drawable(text));
}

void Canvas::clip(PlotPoint corner, FigureSize size) {
  cairo_save(page_->cairo);
  cairo_rectangle(page_->cairo, corner.x, corner.y, size.width, size.height);
  cairo_clip(page_->cairo);
}

void Canvas::unclip() {
  cairo_restore(page_->cairo);
}

std::string Canvas::finish() {
  cairo_surface_flush(page_->surface);
  if (page_->kind == Kind::Png) {
    cairo_surface_write_to_png_stream(page_->surface, append, &page_->bytes);
  } else {
    cairo_surface_finish(page_->surface);
  }
  const auto status = cairo_status(page_->cairo);
  if (status != CAIRO_STATUS_SUCCESS) {
    throw Error{fmt::format("the figure could not be drawn: {}", cairo_status_to_string(status))};
  }
  return page_->bytes;
}

}  // namespace bimodal
