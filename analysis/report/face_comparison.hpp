#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/scoring/unit.hpp"
#include "analysis/statistics/condition_permutation.hpp"
#include "analysis/statistics/contrasts.hpp"
#include "analysis/statistics/interval.hpp"
#include "analysis/statistics/matrix_comparison.hpp"
#include "analysis/statistics/noise_ceiling.hpp"

namespace bimodal::analysis {

struct Results;

/// How a comparison draws at random.
struct Resampling {
  std::int64_t permutations = 10'000;
  std::int64_t splits = 500;  ///< into halves, for the noise ceiling
  Seed seed = 1;
};

/// How alike the confusions of two conditions are: of a natural face ("one"), by which the other is
/// measured, and of a synthetic one ("other").
struct FaceComparison {
  std::string title;         ///< "Initial consonants"
  std::optional<Unit> unit;  ///< absent: two matrices, of whatever
  std::string one;           ///< the conditions' or files' names
  std::string other;
  ConfusionMatrix one_matrix;  ///< with the same labels
  ConfusionMatrix other_matrix;
  MatrixComparison cells;
  std::optional<Mantel> mantel_phi;        ///< of the rows' phi
  std::optional<Mantel> mantel_confusion;  ///< of (p(j|i) + p(i|j)) / 2
  NoiseCeiling ceiling_all;                ///< of all cells
  NoiseCeiling ceiling_off_diagonal;
  ConditionPermutation permutation;
  /// Responses were exchanged one by one, as if all were independent: all that matrices allow.
  bool exchanged_responses = false;
  std::vector<Contrast> contrasts;
  std::int64_t participants = 0;           ///< who have trials in both conditions; 0: not known
  std::optional<Interval> ratio_interval;  ///< 95 %, of the accuracy ratio of words
  std::optional<double> ratio;             ///< of words correct, other / one
  std::string ratio_method;
};

/// Of two matrices; labels need not be the same.
[[nodiscard]] FaceComparison compare_faces(const ConfusionMatrix& one,
                                           const ConfusionMatrix& other,
                                           const Resampling& resampling);

/// Of two conditions in one unit. Throws Error if a condition does not occur, or has no such unit.
[[nodiscard]] FaceComparison compare_faces(const Results& results,
                                           Unit unit,
                                           const std::string& one,
                                           const std::string& other,
                                           const Resampling& resampling);

/// The same in every unit of kPlaceUnits that has responses in both conditions. Throws Error if a
/// condition does not occur.
[[nodiscard]] std::vector<FaceComparison> compare_faces(const Results& results,
                                                        const std::string& one,
                                                        const std::string& other,
                                                        const Resampling& resampling);

/// A cell in which two conditions differ, by where it is in their matrices.
struct DifferentCell {
  std::size_t stimulus = 0;
  std::size_t response = 0;
  double difference = 0.0;  ///< of the row proportions, one less other
  double q = 1.0;
};

/// At this false discovery rate cells differ.
inline constexpr double kFalseDiscoveryRate = 0.05;

/// The cells that differ by the permutation, the largest difference first.
[[nodiscard]] std::vector<DifferentCell> significant_cells(const FaceComparison& comparison);

}  // namespace bimodal::analysis
