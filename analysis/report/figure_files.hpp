#pragma once

#include <vector>

#include "analysis/report/tables.hpp"

namespace bimodal::analysis {

/// The report's figures for papers and slides, each as SVG and PDF and for one column of a journal
/// and for two: figures/NAME-85mm.svg, figures/NAME-85mm.pdf, figures/NAME-174mm.svg, ... Words in
/// them are text, not outlines. Throws Error if a figure cannot be drawn.
[[nodiscard]] std::vector<ReportFile> figure_files(const Results& results, const Making& making);

}  // namespace bimodal::analysis
