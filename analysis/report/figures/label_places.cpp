#include "analysis/report/figures/label_places.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace bimodal::analysis {

namespace {

constexpr double kHardlyLess = 1e-6;  ///< no reason to go farther away

double overlap(double from, double to, double other_from, double other_to) {
  return std::max(0.0, std::min(to, other_to) - std::max(from, other_from));
}

double area_in_common(const Box& one, const Box& other) {
  return overlap(one.left, one.left + one.width, other.left, other.left + other.width) *
         overlap(one.top, one.top + one.height, other.top, other.top + other.height);
}

/// The eight places about a point, then farther ones; the better ones first.
std::vector<Box> candidates(const PlotPoint& point, double width, double height, double radius) {
  std::vector<Box> boxes;
  for (const double away : {radius + 1.0, radius + 6.0, radius + 11.0}) {
    const double right = point.x + away;
    const double left = point.x - away - width;
    const double above = point.y - away - height;
    const double below = point.y + away;
    const double middle = point.y - height / 2;
    const double centre = point.x - width / 2;
    for (const auto& [x, y] : std::to_array<std::pair<double, double>>({{right, middle},
                                                                        {left, middle},
                                                                        {centre, above},
                                                                        {centre, below},
                                                                        {right, above + 2.0},
                                                                        {right, below - 2.0},
                                                                        {left, above + 2.0},
                                                                        {left, below - 2.0}})) {
      boxes.push_back({x, y, width, height});
    }
  }
  return boxes;
}

double cross(const PlotPoint& origin, const PlotPoint& one, const PlotPoint& other) {
  return (one.x - origin.x) * (other.y - origin.y) - (one.y - origin.y) * (other.x - origin.x);
}

/// One half of the hull of points sorted by x and y, without its last point.
template <typename Points>
std::vector<PlotPoint> half_hull(const Points& points) {
  std::vector<PlotPoint> chain;
  for (const auto& point : points) {
    while (chain.size() > 1 && cross(chain[chain.size() - 2], chain.back(), point) <= 0.0) {
      chain.pop_back();
    }
    chain.push_back(point);
  }
  chain.pop_back();
  return chain;
}

}  // namespace

std::vector<Box> place_labels(std::span<const PlotPoint> points,
                              std::span<const double> widths,
                              double height,
                              double radius,
                              const Box& bounds) {
  std::vector<Box> taken;
  for (const auto& point : points) {
    taken.push_back({point.x - radius, point.y - radius, 2 * radius, 2 * radius});
  }
  std::vector<Box> placed;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    Box best;
    for (const auto& box : candidates(points[i], widths[i], height, radius)) {
      const double outside = box.width * box.height - area_in_common(box, bounds);
      double covered = 4.0 * outside;
      for (const auto& other : taken) covered += area_in_common(box, other);
      if (covered > least - kHardlyLess) continue;
      least = covered;
      best = box;
    }
    placed.push_back(best);
    taken.push_back(best);
  }
  return placed;
}

std::vector<PlotPoint> convex_hull(std::vector<PlotPoint> points) {
  const auto place = [](const PlotPoint& point) { return std::pair{point.x, point.y}; };
  std::ranges::sort(points, {}, place);
  const auto end =
      std::unique(points.begin(), points.end(), [&](const PlotPoint& one, const PlotPoint& other) {
        return place(one) == place(other);
      });
  points.erase(end, points.end());
  if (points.size() < 3) return points;
  auto hull = half_hull(points);
  std::ranges::reverse(points);
  const auto upper = half_hull(points);
  hull.insert(hull.end(), upper.begin(), upper.end());
  return hull;
}

}  // namespace bimodal::analysis
