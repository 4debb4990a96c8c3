#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {

/// How rows and columns of a confusion matrix are laid out in a figure.
struct Arrangement {
  std::vector<std::string> order;  ///< of the labels; empty: as the matrix has them
  std::string order_name =
      "place of articulation, front to back";  ///< "a dendrogram (average linkage)"
  /// Lines part labels that are not of the same class, labels of no class from everything; empty:
  /// lines part places of articulation.
  std::vector<std::vector<std::string>> classes;
};

/// Which rows and columns a panel shows, in order, by their numbers in the matrix.
struct MatrixAxes {
  std::vector<std::size_t> rows;
  /// First the labels that stimuli have or could have, then what is none ("blank", "other").
  std::vector<std::size_t> columns;
  std::size_t extras = 0;            ///< how many of the last columns are none
  std::vector<bool> row_borders;     ///< whether a line stands before each of `rows`
  std::vector<bool> column_borders;  ///< before each of `columns`
};

/// Labels that `order` does not name follow the others as the matrix has them.
[[nodiscard]] MatrixAxes arrange(const ConfusionMatrix& matrix, const Arrangement& arrangement);

}  // namespace bimodal::analysis
