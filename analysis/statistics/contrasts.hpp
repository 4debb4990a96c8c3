#pragma once

#include <string>
#include <vector>

#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {

/// How well two stimuli are told apart in two conditions:
/// the phi of their rows of responses (DissimilarityMeasure::Phi), 0: the same responses, 1: none
/// in common.
struct Contrast {
  std::string stimulus;
  std::string counterpart;
  double one = 0.0;    ///< phi in the first condition (natural)
  double other = 0.0;  ///< in the second (synthetic)
  /// How often either is answered for the other, as a mean proportion of the two rows.
  double confused_one = 0.0;
  double confused_other = 0.0;

  /// What the second condition fails to show; negative: it shows more.
  [[nodiscard]] double loss() const { return one - other; }
};

/// All pairs of stimuli presented in both, the largest loss first. Same labels.
[[nodiscard]] std::vector<Contrast> rank_contrasts(const ConfusionMatrix& one,
                                                   const ConfusionMatrix& other);

}  // namespace bimodal::analysis
