#pragma once

#include <memory>
#include <string>

#include <cairo.h>

namespace bimodal::analysis {

/// A PDF file in the making, by Cairo; sizes in points.
class PdfFile {
 public:
  PdfFile(double width, double height);

  /// To draw on the present page.
  [[nodiscard]] cairo_t* context() const { return context_.get(); }

  void set_title(const std::string& title);
  /// ISO 8601; empty: the beginning of 1970, so that the clock never shows in the bytes.
  void set_date(const std::string& made_utc);
  /// A line of the reader's list of contents that leads to the present page; below the line with
  /// the number `parent`, or 0. Its own number.
  int add_to_outline(const std::string& words, int parent);

  void next_page();

  /// The file's content; nothing can be drawn afterwards. Throws Error if Cairo failed.
  [[nodiscard]] std::string finish();

 private:
  struct Destroy {
    void operator()(cairo_t* context) const { cairo_destroy(context); }

    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };

  std::unique_ptr<std::string> content_;  ///< Cairo writes to it through a pointer
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> context_;
  int page_ = 1;
};

}  // namespace bimodal::analysis
