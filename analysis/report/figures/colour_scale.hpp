#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/report/figures/svg.hpp"

namespace bimodal::analysis {

/// What the colours of a figure mean: a bar of them with ticks below it.
struct ColourScale {
  struct Tick {
    double at = 0.0;  ///< along the bar, 0 to 1
    std::string label;
  };

  std::string caption;                        ///< behind the bar
  std::function<std::string(double)> colour;  ///< along the bar, 0 to 1
  std::vector<Tick> ticks;
};

/// Of row proportions, 0 to 1; the square root gives rare confusions more colour.
[[nodiscard]] ColourScale scale_of_proportions(bool is_square_root);

/// Of differences from -`largest` to `largest`.
[[nodiscard]] ColourScale scale_of_differences(double largest, std::string caption);

inline constexpr double kScaleHeight = 18.0;  ///< with its ticks, in points

/// Draws the bar with its upper left corner there, in points.
void paint_scale(Svg& svg, const ColourScale& scale, double left, double top);

}  // namespace bimodal::analysis
