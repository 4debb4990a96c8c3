#pragma once

#include <string>

#include "analysis/report/exported_matrix.hpp"

namespace bimodal::analysis {

/// A matrix as a table of a paper: "20 (.83)" is a count and its proportion of the row, a count of
/// 0 stands alone, and n is the number of responses in the row. Title above; orientation, order and
/// n in the note below.

/// LaTeX, after the tables of the APA (2020, Publication manual, 7th ed., ch. 7): number bold,
/// title in italics, three rules, of which \usepackage{booktabs} knows.
[[nodiscard]] std::string matrix_latex(const ExportedMatrix& exported);

/// Markdown with tables (GitHub Flavored Markdown, 4.10).
[[nodiscard]] std::string matrix_markdown(const ExportedMatrix& exported);

}  // namespace bimodal::analysis
