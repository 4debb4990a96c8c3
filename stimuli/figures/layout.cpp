#include "stimuli/figures/layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "stimuli/figures/panel_painter.hpp"

namespace bimodal {

namespace {

constexpr double kMargin = 10;
constexpr double kTitleSize = 12;
constexpr double kCaptionSize = 9;
constexpr double kCaptionLine = 13;
/// DejaVu Sans: an average letter is this part of its size wide; to reckon the caption's height
/// before there is a page to measure it on.
constexpr double kLetterWidth = 0.56;

double inner_width(const Figure& figure) {
  const auto columns = std::min(figure.columns, figure.panels.size());
  return static_cast<double>(columns) * figure.panel_width;
}

std::vector<std::string> caption_lines(const Figure& figure) {
  const auto most = static_cast<std::size_t>(inner_width(figure) / (kCaptionSize * kLetterWidth));
  std::vector<std::string> lines;
  std::istringstream words{figure.caption};
  for (std::string word; words >> word;) {
    if (lines.empty() || lines.back().size() + 1 + word.size() > most) {
      lines.push_back(word);
    } else {
      lines.back() += ' ' + word;
    }
  }
  return lines;
}

double title_height(const Figure& figure) {
  return figure.title.empty() ? 0 : kTitleSize + 8;
}

void widen(std::pair<double, double>& range, double value) {
  if (!std::isfinite(value)) return;
  range = {std::min(range.first, value), std::max(range.second, value)};
}

constexpr std::pair kNothing{std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()};

std::pair<double, double> usable(std::pair<double, double> range, double margin) {
  if (range.first > range.second) return {0, 1};
  const double width = range.second - range.first;
  const double room = width > 0 ? margin * width : std::max(0.5, 0.05 * std::abs(range.first));
  return {range.first - room, range.second + room};
}

}  // namespace

std::vector<double> ticks(double low, double high, int wanted) {
  const double width = high - low;
  if (!std::isfinite(width) || width <= 0 || wanted < 1) return {};
  const double rough = width / wanted;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  const double parts = rough / power;
  const double step = power * (parts < 1.5 ? 1 : parts < 3.5 ? 2 : parts < 7.5 ? 5 : 10);
  std::vector<double> made;
  const auto first = std::ceil(low / step - 1e-9);
  for (double i = first; i * step <= high + 1e-9 * step; ++i) {
    made.push_back(std::abs(i * step) < 1e-12 * width ? 0 : i * step);
  }
  return made;
}

PanelRange range_of(const Panel& panel) {
  auto x = kNothing;
  auto y = kNothing;
  const auto include = [&](const std::vector<PlotPoint>& points) {
    for (const auto& point : points) {
      widen(x, point.x);
      widen(y, point.y);
    }
  };
  for (const auto& curve : panel.curves) include(curve.points);
  for (const auto& marks : panel.marks) include(marks.points);
  for (const auto& stretch : panel.stretches) {
    widen(x, stretch.from);
    widen(x, stretch.to);
  }
  if (!panel.x_names.empty()) {
    widen(x, -0.5);
    widen(x, static_cast<double>(panel.x_names.size()) - 0.5);
  }
  return {.x = panel.x_range.value_or(usable(x, 0)), .y = panel.y_range.value_or(usable(y, 0.06))};
}

FigureSize size_of(const Figure& figure) {
  const auto columns = std::max<std::size_t>(1, std::min(figure.columns, figure.panels.size()));
  const auto rows = (figure.panels.size() + columns - 1) / columns;
  return {.width = inner_width(figure) + 2 * kMargin,
          .height = 2 * kMargin + title_height(figure) +
                    static_cast<double>(rows) * figure.panel_height +
                    kCaptionLine * static_cast<double>(caption_lines(figure).size())};
}

void draw(const Figure& figure, FigureSize size, Canvas& canvas) {
  double top = kMargin;
  if (!figure.title.empty()) {
    const double width = 1.12 * canvas.width_of(figure.title, kTitleSize);  // of the bold letters
    const double fitting = std::min(1.0, inner_width(figure) / width);
    canvas.words(
        figure.title, {kMargin, top + kTitleSize}, kTitleSize * fitting, Align::Left, true);
    top += title_height(figure);
  }
  const auto columns = std::max<std::size_t>(1, figure.columns);
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const auto& panel = figure.panels[i];
    const bool is_gap = panel.title.empty() && panel.curves.empty() && panel.marks.empty() &&
                        panel.stretches.empty() && panel.lines.empty();
    if (is_gap) continue;
    const auto row = i / columns;
    const auto column = i % columns;
    const PlotPoint corner{kMargin + static_cast<double>(column) * figure.panel_width,
                           top + static_cast<double>(row) * figure.panel_height};
    paint_panel(
        panel, corner, {.width = figure.panel_width, .height = figure.panel_height}, canvas);
  }
  const auto lines = caption_lines(figure);
  double base =
      size.height - kMargin - kCaptionLine * static_cast<double>(lines.size()) + kCaptionSize;
  for (const auto& line : lines) {
    canvas.words(line, {kMargin, base}, kCaptionSize, Align::Left);
    base += kCaptionLine;
  }
}

}  // namespace bimodal
