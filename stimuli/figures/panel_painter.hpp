#pragma once

#include "stimuli/figures/canvas.hpp"
#include "stimuli/figures/figure.hpp"

namespace bimodal {

/// Draws one panel with its axes into the box of `size` at `corner`.
void paint_panel(const Panel& panel, PlotPoint corner, FigureSize size, Canvas& canvas);

}  // namespace bimodal
