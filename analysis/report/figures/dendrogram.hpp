#pragma once

#include <string>

#include "analysis/report/figures/svg.hpp"
#include "analysis/report/structure_table.hpp"

namespace bimodal::analysis {

/// The merges of a clustering as a tree that grows from its leaves at the right to the left, as
/// high as the merged clusters are unlike; a dashed line cuts it into the table's classes, which
/// brackets show with the part of the responses that each keeps.
[[nodiscard]] std::string dendrogram(const ClusterTable& table, PaperWidth width);

}  // namespace bimodal::analysis
