#include "stimuli/figures/panel_painter.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "stimuli/figures/layout.hpp"

namespace bimodal {

namespace {

constexpr double kWordSize = 9;
constexpr FigureColour kAxis = 0x606060;
constexpr FigureColour kGrid = 0xE4E4E4;

/// The rectangle of the coordinate system, and the way from values to points.
class PanelPainter {
 public:
  PanelPainter(const Panel& panel, PlotPoint corner, FigureSize size, Canvas& canvas)
      : panel_{panel}, canvas_{canvas}, range_{range_of(panel)}, corner_{corner} {
    const double top = (panel.title.empty() ? 6 : 18) + (has_names_above() ? 13 : 0);
    box_ = {.width = size.width - kLeft - kRight,
            .height = size.height - top - (panel.x_label.empty() ? 22 : 34)};
    origin_ = {corner.x + kLeft, corner.y + top};
  }

  void paint() {
    paint_axes();
    paint_stretches();
    canvas_.clip(origin_, box_);
    for (const auto& line : panel_.lines) paint_line(line);
    for (const auto& curve : panel_.curves) {
      std::vector<PlotPoint> points;
      for (const auto& point : curve.points) points.push_back(place(point));
      canvas_.path(points, curve.colour, curve.width, curve.stroke);
    }
    canvas_.unclip();
    for (const auto& marks : panel_.marks) {
      for (const auto& point : marks.points) {
        canvas_.circle(place(point), 3.2, marks.colour, marks.is_filled);
      }
    }
    for (const auto& line : panel_.lines) {
      const double x = place({line.x, 0}).x;
      const bool is_right = x > origin_.x + box_.width / 2;
      canvas_.words(line.label,
                    {is_right ? x - 3 : x + 3, origin_.y + 10},
                    kWordSize,
                    is_right ? Align::Right : Align::Left);
    }
    paint_legend();
  }

 private:
  static constexpr double kLeft = 54;
  static constexpr double kRight = 12;

  [[nodiscard]] bool has_names_above() const { return !panel_.stretches.empty(); }

  [[nodiscard]] PlotPoint place(PlotPoint value) const {
    return {
        origin_.x + (value.x - range_.x.first) / (range_.x.second - range_.x.first) * box_.width,
        origin_.y + (range_.y.second - value.y) / (range_.y.second - range_.y.first) * box_.height};
  }

  void line(PlotPoint from, PlotPoint to, FigureColour colour, double width, Stroke stroke) {
    canvas_.path(std::array{from, to}, colour, width, stroke);
  }

  void paint_axes() {
    constexpr double kTitleSize = 10;
    constexpr double kSmallestTitle = 6;
    constexpr double kBold = 1.12;  // bold letters are wider than those that are measured
    const double width = kBold * canvas_.width_of(panel_.title, kTitleSize);
    const double room = box_.width + kRight;
    const double fitting =
        width > room ? std::max(kSmallestTitle, kTitleSize * room / width) : kTitleSize;
    canvas_.words(panel_.title, {corner_.x + kLeft, corner_.y + 12}, fitting, Align::Left, true);
    const double bottom = origin_.y + box_.height;
    const auto y_ticks =
        ticks(range_.y.first, range_.y.second, std::max(2, static_cast<int>(box_.height / 32)));
    for (const double value : y_ticks) {
      const double y = place({0, value}).y;
      line({origin_.x, y}, {origin_.x + box_.width, y}, kGrid, 0.7, Stroke::Solid);
      canvas_.words(fmt::format("{:.6g}", value), {origin_.x - 5, y + 3}, kWordSize, Align::Right);
    }
    if (panel_.x_names.empty()) {
      for (const double value :
           ticks(range_.x.first, range_.x.second, std::max(2, static_cast<int>(box_.width / 55)))) {
        tick(value, fmt::format("{:.6g}", value));
      }
    } else {
      for (std::size_t i = 0; i < panel_.x_names.size(); ++i) {
        tick(static_cast<double>(i), panel_.x_names[i]);
      }
    }
    line(origin_, {origin_.x, bottom}, kAxis, 0.8, Stroke::Solid);
    line({origin_.x, bottom}, {origin_.x + box_.width, bottom}, kAxis, 0.8, Stroke::Solid);
    const double middle = origin_.x + box_.width / 2;
    canvas_.words(panel_.x_label, {middle, bottom + 26}, kWordSize, Align::Centre);
    canvas_.words_upwards(panel_.y_label, {corner_.x + 12, origin_.y + box_.height / 2}, kWordSize);
  }

  void tick(double value, const std::string& label) {
    const double x = place({value, 0}).x;
    const double bottom = origin_.y + box_.height;
    line({x, bottom}, {x, bottom + 3}, kAxis, 0.8, Stroke::Solid);
    canvas_.words(label, {x, bottom + 13}, kWordSize, Align::Centre);
  }

  /// A name that would run into the one before it is left out.
  void paint_stretches() {
    double free_from = corner_.x;
    for (const auto& stretch : panel_.stretches) {
      const double from = place({stretch.from, 0}).x;
      const double to = place({stretch.to, 0}).x;
      for (const double x : {from, to}) {
        line({x, origin_.y}, {x, origin_.y + box_.height}, kGrid, 0.7, Stroke::Solid);
      }
      const double middle = (from + to) / 2;
      const double half = canvas_.width_of(stretch.label, kWordSize) / 2;
      if (middle - half < free_from) continue;
      canvas_.words(stretch.label, {middle, origin_.y - 4}, kWordSize, Align::Centre);
      free_from = middle + half + 1;
    }
  }

  void paint_line(const Line& mark) {
    const double x = place({mark.x, 0}).x;
    line({x, origin_.y}, {x, origin_.y + box_.height}, kAxis, 1.0, mark.stroke);
  }

  /// Where it covers the least of what is drawn.
  void paint_legend() {
    double widest = 0;
    double lines = 0;
    const auto measure = [&](const std::string& label) {
      if (label.empty()) return;
      widest = std::max(widest, canvas_.width_of(label, kWordSize));
      ++lines;
    };
    for (const auto& curve : panel_.curves) measure(curve.label);
    for (const auto& marks : panel_.marks) measure(marks.label);
    if (lines == 0) return;
    const FigureSize size{.width = widest + 34, .height = 12.5 * lines + 4};
    const PlotPoint corner = emptiest_place(size);
    canvas_.box(corner, size, 0xFFFFFF);
    double base = corner.y + 11;
    for (const auto& curve : panel_.curves) {
      if (curve.label.empty()) continue;
      canvas_.path(
          std::array{PlotPoint{corner.x + 4, base - 3}, PlotPoint{corner.x + 24, base - 3}},
          curve.colour,
          curve.width,
          curve.stroke);
      canvas_.words(curve.label, {corner.x + 29, base}, kWordSize, Align::Left);
      base += 12.5;
    }
    for (const auto& marks : panel_.marks) {
      if (marks.label.empty()) continue;
      canvas_.circle({corner.x + 14, base - 3}, 3.2, marks.colour, marks.is_filled);
      canvas_.words(marks.label, {corner.x + 29, base}, kWordSize, Align::Left);
      base += 12.5;
    }
  }

  [[nodiscard]] PlotPoint emptiest_place(FigureSize size) const {
    std::vector<PlotPoint> corners;
    const FigureSize room{.width = std::max(0.0, box_.width - size.width - 8),
                          .height = std::max(0.0, box_.height - size.height - 8)};
    for (const double down : {0.0, 1.0, 0.5}) {
      for (const double across : {1.0, 0.0, 0.8, 0.2, 0.6, 0.4}) {
        corners.push_back(
            {origin_.x + 4 + across * room.width, origin_.y + 4 + down * room.height});
      }
    }
    const auto covered = [&](const PlotPoint& corner) {
      std::size_t count = 0;
      const auto add = [&](const std::vector<PlotPoint>& points, std::size_t weight) {
        for (const auto& point : points) {
          const auto at = place(point);
          const bool is_within = at.x >= corner.x && at.x <= corner.x + size.width &&
                                 at.y >= corner.y && at.y <= corner.y + size.height;
          count += is_within ? weight : 0;
        }
      };
      for (const auto& curve : panel_.curves) add(curve.points, 1);
      for (const auto& marks : panel_.marks) add(marks.points, 20);
      return count;
    };
    return *std::ranges::min_element(corners, {}, covered);
  }

  const Panel& panel_;
  Canvas& canvas_;
  PanelRange range_;
  PlotPoint corner_;
  FigureSize box_;
  PlotPoint origin_;
};

}  // namespace

void paint_panel(const Panel& panel, PlotPoint corner, FigureSize size, Canvas& canvas) {
  PanelPainter{panel, corner, size, canvas}.paint();
}

}  // namespace bimodal
