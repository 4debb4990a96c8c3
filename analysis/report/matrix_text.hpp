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

/// A proportion as tables of this field print it: two decimals, no leading zero (".07", "1.00").
[[nodiscard]] std::string print_proportion(double proportion);

/// A number of responses: "86", or "86.5" where responses were shared out between cells.
[[nodiscard]] std::string print_count(double count);

}  // namespace bimodal::analysis
