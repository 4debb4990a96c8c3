#pragma once

#include <string>
#include <vector>

#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {

/// How unlike things are, two by two: symmetric, 0 to themselves, never negative.
class Dissimilarities {
 public:
  /// All 0.
  explicit Dissimilarities(std::vector<std::string> labels);

  [[nodiscard]] const std::vector<std::string>& labels() const { return labels_; }

  [[nodiscard]] std::size_t size() const { return labels_.size(); }

  [[nodiscard]] double between(std::size_t one, std::size_t other) const;

  void set(std::size_t one, std::size_t other, double value);

 private:
  std::vector<std::string> labels_;
  std::vector<double> values_;  ///< row by row
};

enum class DissimilarityMeasure {
  /// The square root of phi-square: of chi-square of the table that the two rows make, over its
  /// total; columns that both lack are left out. 0: the same proportions; 1: no response in common,
  /// if both were presented equally often (Iverson, Bernstein & Auer, 1998, Speech Commun. 26,
  /// 45-63).
  Phi,
  /// 1 less the mean of the two proportions with which each is answered for the other.
  Confusion,
};

/// Of the stimuli that were presented, the others left out.
[[nodiscard]] Dissimilarities dissimilarities(const ConfusionMatrix& matrix,
                                              DissimilarityMeasure measure);

}  // namespace bimodal::analysis
