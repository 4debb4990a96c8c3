#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "analysis/report/figures/svg.hpp"

namespace bimodal::analysis {

enum class Mark { Circle, Square, Triangle, Diamond };

/// Different for neighbours, as colours are not all that tells conditions apart.
[[nodiscard]] Mark series_mark(std::size_t index);

/// Centred there, about 2 `radius` wide, in points.
void paint_mark(Svg& svg, Mark mark, double x, double y, double radius, const Paint& paint);

struct LegendEntry {
  std::string name;
  std::string colour;
  Mark mark = Mark::Circle;
};

/// Names in lines from `left` to the figure's right edge, in points; the lower edge.
[[nodiscard]] double paint_legend(Svg& svg,
                                  std::span<const LegendEntry> entries,
                                  double left,
                                  double top);

}  // namespace bimodal::analysis
