#pragma once

#include <span>
#include <vector>

#include "analysis/report/figures/svg.hpp"
#include "stimuli/figures/figure.hpp"

namespace bimodal::analysis {

/// For points with labels of these widths and one height: the box of each label beside its point,
/// above, below or at a corner, such that it covers as little as possible of other labels and
/// points and stays within `bounds`. One after the other, so that the first have the best places.
[[nodiscard]] std::vector<Box> place_labels(std::span<const PlotPoint> points,
                                            std::span<const double> widths,
                                            double height,
                                            double radius,
                                            const Box& bounds);

/// The corners of the smallest convex polygon about the points, counter-clockwise where y grows
/// upwards (Andrew's monotone chain, 1979); one or two points stay what they are.
[[nodiscard]] std::vector<PlotPoint> convex_hull(std::vector<PlotPoint> points);

}  // namespace bimodal::analysis
