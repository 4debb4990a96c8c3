#pragma once

#include "analysis/report/figures/matrix_panel.hpp"
#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {

/// Smaller proportions are not printed.
inline constexpr double kPrintedFrom = 0.005;

/// The colour and the words of a cell that shows a row proportion; without number.
[[nodiscard]] CellLook look_of_proportion(const ConfusionMatrix& matrix,
                                          std::size_t row,
                                          std::size_t column,
                                          bool is_square_root);

/// Of a cell that shows the difference of two row proportions, one less the other, on a scale up to
/// `largest`; grey where one of them is not known. With its number.
[[nodiscard]] CellLook look_of_difference(const ConfusionMatrix& one,
                                          const ConfusionMatrix& other,
                                          std::size_t row,
                                          std::size_t column,
                                          double largest);

/// The number of presentations at the end of a row.
[[nodiscard]] RowNote note_of_total(const ConfusionMatrix& matrix, std::size_t row);

}  // namespace bimodal::analysis
