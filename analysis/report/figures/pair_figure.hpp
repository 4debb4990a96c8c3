#pragma once

#include <string>
#include <vector>

#include "analysis/report/figures/matrix_axes.hpp"
#include "analysis/report/figures/svg.hpp"

namespace bimodal::analysis {

/// Two conditions whose confusions are compared, the natural face's and the synthetic one's as a
/// rule. Both matrices have the same labels.
struct ConditionPair {
  std::string title;    ///< "Initial consonants"
  std::string natural;  ///< the conditions' names
  std::string synthetic;
  ConfusionMatrix natural_matrix;
  ConfusionMatrix synthetic_matrix;
  /// Of each cell, row by row as the matrices have them: whether the two conditions differ in it by
  /// a test. Empty: not tested.
  std::vector<bool> significant;
  std::string test;  ///< which: "permutation test, false discovery rate .05"
};

/// The two matrices on one scale of row proportions, and the first less the second on a scale that
/// diverges from 0 to both sides up to the largest difference, with significant cells outlined.
/// Side by side where cells have room for letters of 5 points, else the difference below the two
/// (over two columns) or all three below each other (over one).
[[nodiscard]] std::string pair_figure(const ConditionPair& pair,
                                      const Arrangement& arrangement,
                                      PaperWidth width);

}  // namespace bimodal::analysis
