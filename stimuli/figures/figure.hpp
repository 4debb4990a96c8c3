#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bimodal {

/// 0xRRGGBB.
using FigureColour = std::uint32_t;

/// Eight colours that people with any colour vision tell apart (Okabe & Ito 2008), black first;
/// beyond them they begin again.
[[nodiscard]] FigureColour figure_colour(std::size_t index);

struct PlotPoint {
  double x = 0;
  double y = 0;
};

enum class Stroke : std::uint8_t { Solid, Dashed, Dotted };

/// Points joined by straight lines.
struct Curve {
  std::vector<PlotPoint> points;
  FigureColour colour = 0;
  Stroke stroke = Stroke::Solid;
  double width = 1.6;  ///< in points
  std::string label;   ///< in the panel's legend; empty: not named there
};

/// Circles, e.g. targets or measured values.
struct Marks {
  std::vector<PlotPoint> points;
  FigureColour colour = 0;
  bool is_filled = false;
  std::string label;
};

/// A stretch of the x axis with its name above the panel, e.g. a segment.
struct Stretch {
  double from = 0;
  double to = 0;
  std::string label;
};

/// A vertical line with a note at its upper end.
struct Line {
  double x = 0;
  std::string label;
  Stroke stroke = Stroke::Dotted;
};

/// One coordinate system. Ranges that are absent are taken from what is drawn.
struct Panel {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::optional<std::pair<double, double>> x_range;
  std::optional<std::pair<double, double>> y_range;
  std::vector<Curve> curves;
  std::vector<Marks> marks;
  std::vector<Stretch> stretches;
  std::vector<Line> lines;
  std::vector<std::string> x_names;  ///< instead of numbers, at 0, 1, 2 ...
};

/// Panels in rows from left to right and top to bottom, each of the same size. One without anything
/// in it leaves its place empty.
struct Figure {
  std::string title;
  std::string caption;  ///< below the panels, wrapped to the width
  std::vector<Panel> panels;
  std::size_t columns = 1;
  double panel_width = 460;   ///< in points (1/72 inch)
  double panel_height = 200;  ///< in points
};

/// The figure as an SVG document, whose <title> and <desc> are the figure's title and caption. The
/// same figure gives the same bytes. Throws Error if a figure has no panels or is too large.
[[nodiscard]] std::string svg_of(const Figure& figure);

/// Writes the figure to an .svg, .pdf or .png file (2 pixels a point), as its name ends. Throws
/// Error if the ending is another or the file cannot be written.
void write_figure(const Figure& figure, const std::filesystem::path& file);

}  // namespace bimodal
