#pragma once

#include <string>
#include <vector>

#include "analysis/report/figures/svg.hpp"
#include "analysis/report/structure_table.hpp"

namespace bimodal::analysis {

/// Where stimuli lie in the first two dimensions of a layout, one length for both, with the convex
/// hull of each class of labels (as of ClusterTable; none: no hulls) tinted.
[[nodiscard]] std::string layout_figure(const LayoutTable& table,
                                        const std::vector<std::vector<std::string>>& classes,
                                        PaperWidth width);

}  // namespace bimodal::analysis
