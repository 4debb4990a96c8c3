#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "stimuli/figures/figure.hpp"

namespace bimodal {

/// In points (1/72 inch).
struct FigureSize {
  double width = 0;
  double height = 0;
};

enum class Align : std::uint8_t { Left, Centre, Right };

/// Lines, circles and words on a white page; Cairo draws them. Coordinates are points from the
/// upper left corner.
class Canvas {
 public:
  enum class Kind : std::uint8_t { Svg, Pdf, Png };

  Canvas(Kind kind, FigureSize size);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  Canvas(Canvas&&) = delete;
  Canvas& operator=(Canvas&&) = delete;

  void path(std::span<const PlotPoint> points, FigureColour colour, double width, Stroke stroke);
  void circle(PlotPoint centre, double radius, FigureColour colour, bool is_filled);
  void box(PlotPoint corner, FigureSize size, FigureColour colour);

  /// `y` is the base line. Words that are not UTF-8 show as question marks.
  void words(std::string_view text, PlotPoint at, double size, Align align, bool is_bold = false);
  /// Upwards, centred on `at`.
  void words_upwards(std::string_view text, PlotPoint at, double size);

  [[nodiscard]] double width_of(std::string_view text, double size) const;

  /// Only what is drawn within this box from now on shows, until unclip.
  void clip(PlotPoint corner, FigureSize size);
  void unclip();

  /// The file's content; nothing can be drawn afterwards. Throws Error if Cairo failed.
  [[nodiscard]] std::string finish();

 private:
  struct Page;
  std::unique_ptr<Page> page_;
};

}  // namespace bimodal
