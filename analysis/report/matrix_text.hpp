#pragma once

#include <string>

#include "analysis/report/confusions.hpp"

namespace bimodal::analysis {

/// A matrix as CSV: the first column is the stimulus, the header names the responses, the cells are
/// counts. What was left out as ambiguous is not in it.
[[nodiscard]] std::string matrix_csv(const ConfusionMatrix& matrix);

/// The same for reading in a terminal: row proportions (nothing for zero), row n, and how much is
/// correct. Columns without any response are left out.
[[nodiscard]] std::string matrix_text(const std::string& title, const ConfusionMatrix& matrix);

/// "Not in the table: ...": ambiguous alignments, words without the unit.
[[nodiscard]] std::string left_out_text(const UnitConfusions& confusions);

}  // namespace bimodal::analysis
