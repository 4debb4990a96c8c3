#pragma once

#include <string>

#include "analysis/report/figures/matrix_axes.hpp"
#include "analysis/report/figures/svg.hpp"

namespace bimodal::analysis {

/// What colours and numbers of a confusion matrix tell.
struct HeatMapOptions {
  /// Which numbers stand in cells: row proportions above .005, or counts above 0.
  enum class Numbers { Proportions, Counts, None };

  std::string title;  ///< "Initial consonants, condition visual"
  Arrangement arrangement;
  bool is_square_root = false;  ///< the scale of colours
  Numbers numbers = Numbers::Proportions;
  PaperWidth width = PaperWidth::TwoColumns;
};

/// A confusion matrix: rows are stimuli and columns responses; colours are row proportions in one
/// hue on the fixed scale 0-1, which stands below; row n at the right, slanted and orange below 10.
/// Rows of stimuli that were not presented are grey. Cells without a response are white.
[[nodiscard]] std::string heat_map(const ConfusionMatrix& matrix, const HeatMapOptions& options);

/// What a caption says of how the map is drawn: order, lines, scale and numbers.
[[nodiscard]] std::string describe(const HeatMapOptions& options);

}  // namespace bimodal::analysis
