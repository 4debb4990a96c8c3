#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/report/figures/svg.hpp"
#include "analysis/report/results.hpp"

namespace bimodal::analysis {

/// Proportion of correct words in each condition: the pooled value with its interval, and a dot for
/// every participant.
[[nodiscard]] std::string figure_of_words(const Results& results, PaperWidth width);

/// A confusion matrix by place of articulation.
[[nodiscard]] std::string figure_of_confusions(const UnitConfusions& confusions, PaperWidth width);

/// One of the report's figures, to be drawn at any width; borrows the results.
struct ReportFigure {
  std::string name;  ///< as its files are named, without extension
  std::function<std::string(PaperWidth)> draw;
};

/// All figures that become files of their own: words, and every confusion matrix with its
/// dendrogram and layout.
[[nodiscard]] std::vector<ReportFigure> report_figures(const Results& results);

}  // namespace bimodal::analysis
