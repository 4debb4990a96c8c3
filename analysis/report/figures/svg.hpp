#pragma once

#include <string>
#include <string_view>

namespace bimodal::analysis {

/// How wide journals print a figure: over one column of text, or over both.
enum class PaperWidth { OneColumn, TwoColumns };

/// 85 or 174.
[[nodiscard]] double millimetres(PaperWidth width);

/// The same in points (1/72 inch), the unit of all coordinates and sizes in figures.
[[nodiscard]] double points(PaperWidth width);

/// Colours of what is no data.
inline constexpr std::string_view kInk = "#1b2733";
inline constexpr std::string_view kSoftInk = "#5b6875";
inline constexpr std::string_view kRule = "#b4bec8";
inline constexpr std::string_view kUnknown = "#e9e9e9";  ///< cells of which nothing is known

enum class Anchor { Start, Middle, End };

/// How words are set.
struct Lettering {
  double size = 7.0;
  Anchor anchor = Anchor::Start;
  std::string_view colour = kInk;
  bool is_bold = false;
  bool is_italic = false;
  bool is_upright = false;  ///< read upwards
};

/// How a shape is filled and outlined.
struct Paint {
  std::string_view fill = "none";
  std::string_view stroke = "none";
  double width = 0.5;        ///< of the outline
  std::string_view dashes;   ///< "2 2"; empty: a solid line
  double opacity = 1.0;      ///< of the whole shape
  std::string_view meaning;  ///< told where the pointer rests on it; empty: nothing
  std::string_view cell;     ///< "F V": whose cell of a matrix it is, as data-cell; empty: none
  std::string_view side;     ///< of two matrices in the figure whose, as data-side; empty: of one
};

struct Box {
  double left = 0.0;
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;
};

/// How wide words are in the widest sans-serif font in use (DejaVu Sans), so that what has room
/// there has room in any.
[[nodiscard]] double width_of(std::string_view text, double size, bool is_bold = false);

/// Builds one figure: an SVG element that is well-formed XML, has text as text and no script, and
/// brings its style with it, so that it looks the same on a page, in a file and on paper.
class Svg {
 public:
  /// `description` is read by screen readers behind the title: the figure's numbers, where few.
  Svg(double width, std::string title, std::string description);

  [[nodiscard]] double width() const { return width_; }

  /// `y` is the base line.
  void text(double x, double y, std::string_view words, const Lettering& lettering = {});
  void box(const Box& box, const Paint& paint);
  void line(double x1, double y1, double x2, double y2, const Paint& paint);
  void circle(double x, double y, double radius, const Paint& paint);
  /// `commands` as in SVG's attribute d.
  void path(std::string_view commands, const Paint& paint);

  /// The element; nothing can be drawn afterwards.
  [[nodiscard]] std::string finish(double height);

 private:
  void shape(std::string_view geometry, const Paint& paint);

  double width_;
  std::string title_;
  std::string description_;
  std::string content_;
};

/// An SVG element of the page as a document of its own, on white.
[[nodiscard]] std::string standing_alone(std::string element);

/// A coordinate with two decimals at most ("12.5").
[[nodiscard]] std::string coordinate(double value);

}  // namespace bimodal::analysis
