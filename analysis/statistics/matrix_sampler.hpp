#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "analysis/statistics/confusion_matrix.hpp"
#include "stimuli/base/random.hpp"

namespace bimodal::analysis {

/// Whole counts of a matrix, row by row.
using CellCounts = std::vector<std::int32_t>;

/// Draws matrices with the same number of responses to every stimulus, each response independently
/// from its row's proportions (alias method: Walker, 1977, ACM Trans. Math. Softw. 3, 253-256).
class MatrixSampler {
 public:
  /// `proportions` row by row, >= 0; rows that have responses sum to about 1.
  MatrixSampler(std::vector<double> proportions,
                std::vector<std::int64_t> row_totals,
                std::size_t columns);

  void draw(Random& random, CellCounts& counts) const;

 private:
  struct Column {
    std::uint64_t threshold = 0;  ///< of 2^32
    /// From the threshold on its alias, below it the column itself; chosen by index, because no
    /// processor can foresee which it will be.
    std::array<std::uint32_t, 2> drawn{};
  };

  static void make_aliases(std::span<const double> proportions, std::span<Column> row);

  std::vector<std::int64_t> row_totals_;
  std::size_t columns_;
  std::vector<Column> table_;  ///< row by row
};

/// The proportions of a matrix with something for cells that did not occur: in each row as much as
/// Good & Turing estimate to be unseen (the share of responses given once; Good, 1953, Biometrika
/// 40, 237-264; at most half), shared out by how often the responses were given to any stimulus.
/// Row by row; empty rows are all 0.
[[nodiscard]] std::vector<double> smoothed_proportions(const CellCounts& counts,
                                                       std::size_t columns);

}  // namespace bimodal::analysis
