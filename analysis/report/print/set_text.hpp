#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <cairo.h>
#include <pango/pango.h>

namespace bimodal::analysis {

/// How a block of words is set. Sizes in points.
struct TextLook {
  double size = 9.0;
  std::string_view colour = "#1b2733";
  bool is_bold = false;
  bool is_right = false;  ///< set at the right edge
};

/// Words in lines, set by Pango.
class SetText {
 public:
  /// `width` of the lines; below 0: one line however long. A word that is longer is parted.
  SetText(cairo_t* context, const std::string& markup, const TextLook& look, double width);

  [[nodiscard]] double width() const;

  /// How wide the widest word is.
  [[nodiscard]] double widest_word() const;

  [[nodiscard]] double height() const;
  [[nodiscard]] int lines() const;

  /// Of one line, from 0.
  [[nodiscard]] double line_height(int line) const;

  /// Upper left corner of all lines.
  void paint(double x, double y) const;

  /// Upper left corner of one line.
  void paint_line(int line, double x, double y) const;

 private:
  struct Release {
    void operator()(PangoLayout* layout) const;
  };

  cairo_t* context_;
  std::unique_ptr<PangoLayout, Release> layout_;
  std::string colour_;
};

/// Makes a colour ("#rrggbb") the context's.
void set_colour(cairo_t* context, std::string_view colour);

}  // namespace bimodal::analysis
