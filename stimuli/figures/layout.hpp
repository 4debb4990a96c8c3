#pragma once

#include <utility>
#include <vector>

#include "stimuli/figures/canvas.hpp"
#include "stimuli/figures/figure.hpp"

namespace bimodal {

/// Round numbers (1, 2 or 5 times a power of ten apart) within a range, about `wanted` of them.
/// Empty if the range is not finite or has no width.
[[nodiscard]] std::vector<double> ticks(double low, double high, int wanted);

/// What a panel shows in each direction: what it asks for, or what is drawn in it and a margin. A
/// range without width is widened.
struct PanelRange {
  std::pair<double, double> x;
  std::pair<double, double> y;
};

[[nodiscard]] PanelRange range_of(const Panel& panel);

[[nodiscard]] FigureSize size_of(const Figure& figure);

/// Draws title, panels and caption.
void draw(const Figure& figure, FigureSize size, Canvas& canvas);

}  // namespace bimodal
