#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/report/label_order.hpp"
#include "analysis/report/provenance.hpp"
#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {

/// A matrix as other programs get it: its counts in full precision, so that read_matrix gives back
/// the same.
struct ExportedMatrix {
  /// Puts the counts in that order; title and warnings become lines of UTF-8. Throws Error; see
  /// reordered.
  ExportedMatrix(std::string_view title,
                 const std::vector<std::string>& warnings,
                 const ConfusionMatrix& matrix,
                 LabelOrder order);

  std::string title;
  std::vector<std::string> warnings;  ///< that readers must have before them: simulated data
  LabelOrder order;
  ConfusionMatrix matrix;
  Provenance provenance;  ///< told where there is a program in it
};

/// What the cells of a table have.
enum class CellContent { Counts, RowProportions };

/// CSV: the first column has the stimuli, the header the responses. Row proportions are empty where
/// a stimulus was never presented. With `header`, lines come before that begin with "# ": title,
/// orientation, cells, order, n, data (trials and exclusions), warnings.
[[nodiscard]] std::string matrix_table_csv(const ExportedMatrix& exported,
                                           CellContent cells,
                                           bool header);

/// CSV with a line for each cell, empty ones too: stimulus, response, count, row_total, proportion.
[[nodiscard]] std::string matrix_list_csv(const ExportedMatrix& exported, bool header);

/// One object: title, orientation, order, n, warnings, data (where they came from), stimuli,
/// row_totals, responses, counts and row_proportions (null in rows without responses).
[[nodiscard]] std::string matrix_json(const ExportedMatrix& exported);

/// A text file of Praat, which opens it as an object of class Confusion (Boersma & Weenink, Praat
/// manual, "Confusion"); the facts of the header are comments in it ("! ...").
[[nodiscard]] std::string matrix_praat(const ExportedMatrix& exported);

}  // namespace bimodal::analysis
