#pragma once

#include <vector>

#include "analysis/report/tables.hpp"

namespace bimodal::analysis {

/// The report's figures as SVG files that stand alone, for papers and slides:
/// figures/words.svg and figures/UNIT-CONDITION.svg for every confusion matrix.
[[nodiscard]] std::vector<ReportFile> figure_files(const Results& results);

}  // namespace bimodal::analysis
