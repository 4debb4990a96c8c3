#include "analysis/report/figures/layout_figure.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/report/figures/colours.hpp"
#include "analysis/report/figures/label_places.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kLetters = 8.0;
constexpr double kAxisLetters = 7.0;
constexpr double kDot = 1.8;
constexpr double kMargin = 22.0;  ///< within the frame, for labels and hulls
constexpr double kLeft = 14.0;
constexpr double kTallest = 330.0;

std::string describe(const LayoutTable& table,
                     const std::vector<std::vector<std::string>>& classes) {
  auto text = fmt::format("Classical scaling of dissimilarities by {}, stress-1 {:.3f}.",
                          name(table.measure),
                          table.layout.stress);
  if (classes.empty()) return text;
  text += " Classes:";
  for (const auto& members : classes) text += fmt::format(" /{}/", fmt::join(members, " "));
  return text + ".";
}

class Painter {
 public:
  Painter(Svg& svg, const LayoutTable& table) : svg_{svg}, table_{table} { measure(); }

  double paint(const std::vector<std::vector<std::string>>& classes) {
    const Box frame{kLeft, 1.0, svg_.width() - kLeft - 1.0, height_};
    svg_.box(frame, {.stroke = kRule, .width = 0.6});
    for (std::size_t i = 0; i < classes.size(); ++i) paint_hull(classes[i], series_colour(i));
    for (const auto& point : points_) {
      svg_.circle(point.x, point.y, kDot, {.fill = "#08306b"});
    }
    paint_labels(frame);
    svg_.text(kLeft + frame.width / 2,
              height_ + kAxisLetters + 3.0,
              "dimension 1",
              {.size = kAxisLetters, .anchor = Anchor::Middle, .colour = kSoftInk});
    svg_.text(
        kAxisLetters,
        height_ / 2,
        "dimension 2",
        {.size = kAxisLetters, .anchor = Anchor::Middle, .colour = kSoftInk, .is_upright = true});
    return height_ + kAxisLetters + 7.0;
  }

 private:
  double coordinate_of(std::size_t thing, std::size_t dimension) const {
    if (dimension >= table_.layout.dimensions) return 0.0;
    return table_.layout.coordinates.at(thing * table_.layout.dimensions + dimension);
  }

  /// Lowest and highest coordinate.
  std::pair<double, double> range_of(std::size_t dimension) const {
    double low = 0.0;
    double high = 0.0;
    for (std::size_t i = 0; i < table_.labels.size(); ++i) {
      low = std::min(low, coordinate_of(i, dimension));
      high = std::max(high, coordinate_of(i, dimension));
    }
    return {low, high};
  }

  void measure() {
    const auto [left, right] = range_of(0);
    const auto [low, high] = range_of(1);
    const double width = svg_.width() - kLeft - 1.0 - 2 * kMargin;
    const double across = std::max(right - left, 1e-9);
    const double up = std::max(high - low, 0.0);
    const double scale = std::min(width / across, (kTallest - 2 * kMargin) / std::max(up, 1e-9));
    height_ = up * scale + 2 * kMargin;
    const double spare = (width - across * scale) / 2;
    for (std::size_t i = 0; i < table_.labels.size(); ++i) {
      points_.push_back({kLeft + kMargin + spare + (coordinate_of(i, 0) - left) * scale,
                         1.0 + kMargin + (high - coordinate_of(i, 1)) * scale});
    }
  }

  void paint_hull(const std::vector<std::string>& members, const std::string& colour) {
    std::vector<PlotPoint> corners;
    for (const auto& member : members) {
      const auto found = std::ranges::find(table_.labels, member);
      if (found == table_.labels.end()) continue;
      corners.push_back(points_[static_cast<std::size_t>(found - table_.labels.begin())]);
    }
    if (corners.size() < 2) return;
    std::string commands;
    for (const auto& corner : convex_hull(std::move(corners))) {
      commands += fmt::format(
          "{}{} {}", commands.empty() ? "M" : "L", coordinate(corner.x), coordinate(corner.y));
    }
    // The thick outline in the same colour leaves room about the points and rounds the corners.
    svg_.path(commands + "Z",
              {.fill = colour,
               .stroke = colour,
               .width = 11.0,
               .opacity = 0.22,
               .meaning = fmt::format("class {}", fmt::join(members, " "))});
  }

  void paint_labels(const Box& frame) {
    std::vector<double> widths;
    for (const auto& label : table_.labels) widths.push_back(width_of(label, kLetters) + 2.0);
    const auto boxes = place_labels(points_, widths, kLetters, kDot, frame);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      paint_leader(points_[i], boxes[i]);
      svg_.text(boxes[i].left + boxes[i].width / 2,
                boxes[i].top + 0.86 * kLetters,
                table_.labels[i],
                {.size = kLetters, .anchor = Anchor::Middle});
    }
  }

  /// A thin line to a label that stands off its point.
  void paint_leader(const PlotPoint& point, const Box& label) {
    const double x = std::clamp(point.x, label.left, label.left + label.width);
    const double y = std::clamp(point.y, label.top, label.top + label.height);
    if (std::hypot(x - point.x, y - point.y) < kDot + 4.0) return;
    svg_.line(point.x, point.y, x, y, {.stroke = kSoftInk, .width = 0.4});
  }

  Svg& svg_;
  const LayoutTable& table_;
  std::vector<PlotPoint> points_;
  double height_ = 0.0;  ///< of the frame
};

}  // namespace

std::string layout_figure(const LayoutTable& table,
                          const std::vector<std::vector<std::string>>& classes,
                          PaperWidth width) {
  Svg svg{points(width), "Layout: " + table.title, describe(table, classes)};
  const double bottom = Painter{svg, table}.paint(classes);
  return svg.finish(bottom);
}

}  // namespace bimodal::analysis
