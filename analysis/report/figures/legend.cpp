#include "analysis/report/figures/legend.hpp"

#include <array>

#include <fmt/format.h>

namespace bimodal::analysis {

namespace {

constexpr double kLetters = 7.5;
constexpr double kLine = 11.0;
constexpr double kBetween = 12.0;  ///< entries
constexpr double kMark = 2.6;

std::string polygon(std::initializer_list<std::array<double, 2>> corners) {
  std::string commands;
  for (const auto& [x, y] : corners) {
    commands += fmt::format("{}{} {}", commands.empty() ? "M" : "L", coordinate(x), coordinate(y));
  }
  return commands + "Z";
}

}  // namespace

Mark series_mark(std::size_t index) {
  constexpr std::array kMarks{Mark::Circle, Mark::Triangle, Mark::Square, Mark::Diamond};
  return kMarks.at(index % kMarks.size());
}

void paint_mark(Svg& svg, Mark mark, double x, double y, double radius, const Paint& paint) {
  const double r = radius;
  switch (mark) {
    case Mark::Circle:
      svg.circle(x, y, r, paint);
      break;
    case Mark::Square:
      svg.box({x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r}, paint);
      break;
    case Mark::Triangle:
      svg.path(polygon({{x, y - 1.2 * r}, {x + 1.1 * r, y + 0.8 * r}, {x - 1.1 * r, y + 0.8 * r}}),
               paint);
      break;
    case Mark::Diamond:
      svg.path(polygon({{x, y - 1.3 * r}, {x + 1.3 * r, y}, {x, y + 1.3 * r}, {x - 1.3 * r, y}}),
               paint);
      break;
  }
}

double paint_legend(Svg& svg, std::span<const LegendEntry> entries, double left, double top) {
  double x = left;
  double y = top;
  for (const auto& entry : entries) {
    const double width = 3.0 * kMark + 2.0 + width_of(entry.name, kLetters);
    if (x > left && x + width > svg.width()) {
      x = left;
      y += kLine;
    }
    paint_mark(svg,
               entry.mark,
               x + kMark,
               y + kLine / 2,
               kMark,
               {.fill = entry.colour, .stroke = entry.colour});
    svg.text(x + 3.0 * kMark, y + kLine / 2 + 0.36 * kLetters, entry.name, {.size = kLetters});
    x += width + kBetween;
  }
  return y + kLine + 3.0;
}

}  // namespace bimodal::analysis
