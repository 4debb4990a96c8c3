#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/statistics/confusion_matrix.hpp"
#include "analysis/statistics/dissimilarity.hpp"
#include "stimuli/base/random.hpp"

namespace bimodal::analysis {

/// The same two matrices with the same labels in the same order: those of the first, then those
/// that only the second has.
[[nodiscard]] std::pair<ConfusionMatrix, ConfusionMatrix> with_common_labels(
    const ConfusionMatrix& one, const ConfusionMatrix& other);

/// How well row proportions p(j|i) agree, cell by cell.
struct CellAgreement {
  std::size_t cells = 0;
  std::optional<double> pearson;   ///< absent without spread
  std::optional<double> spearman;  ///< absent without spread
  std::optional<double> rms_difference;
};

/// One stimulus in both matrices.
struct RowComparison {
  std::string stimulus;
  double n_one = 0.0;
  double n_other = 0.0;
  double divergence = 0.0;   ///< Jensen-Shannon, bits: 0 (alike) to 1 (no response in common)
  double chi_square = 0.0;   ///< Pearson's, of the 2 x k table of counts
  std::int64_t degrees = 0;  ///< of freedom: columns with a response, less 1
};

/// What two matrices alone say about how alike they are, in the stimuli that both presented.
struct MatrixComparison {
  double n_one = 0.0;
  double n_other = 0.0;
  std::optional<double> correct_one;     ///< proportion
  std::optional<double> correct_other;   ///< proportion
  std::optional<double> accuracy_ratio;  ///< other / one; absent if one is never correct
  CellAgreement all;
  CellAgreement off_diagonal;
  std::vector<RowComparison> rows;        ///< presented in both
  std::vector<std::string> not_compared;  ///< stimuli of one matrix alone
  double chi_square = 0.0;                ///< sum over rows
  std::int64_t degrees = 0;
  /// Of the chi-square distribution: of sparse tables too large (rather no difference than a false
  /// one), and for independent responses only. Absent without degrees of freedom.
  std::optional<double> chi_square_p;
  /// 2 sum O ln(O/E), for description: its p-value is wrong for sparse tables and is not given.
  double g = 0.0;
};

/// `one` is what `other` is measured by (natural and synthetic). Labels are the same
/// (with_common_labels). Divergence: Lin, 1991, IEEE Trans. Inf. Theory 37, 145-151.
[[nodiscard]] MatrixComparison compare_matrices(const ConfusionMatrix& one,
                                                const ConfusionMatrix& other);

/// Agreement of the row proportions alone; rows presented in both.
[[nodiscard]] CellAgreement agreement_of_cells(const ConfusionMatrix& one,
                                               const ConfusionMatrix& other,
                                               bool off_diagonal_only);

/// Mantel's test (1967, Cancer Res. 27, 209-220) of whether labels matter: the correlation of two
/// sets of dissimilarities, against those with the labels of one exchanged. A weak null hypothesis:
/// two faces of whatever kind reject it.
struct Mantel {
  std::size_t stimuli = 0;
  double r = 0.0;
  double p = 1.0;  ///< one-sided: (1 + as large) / (1 + permutations), or the share of all orders
  std::int64_t permutations = 0;
  bool enumerated = false;  ///< every order was tried
};

/// Of the stimuli that both have; every order is tried if there are no more than `permutations`.
/// Absent for fewer than 3 stimuli, or without spread.
[[nodiscard]] std::optional<Mantel> mantel(const Dissimilarities& one,
                                           const Dissimilarities& other,
                                           std::int64_t permutations,
                                           Seed seed);

}  // namespace bimodal::analysis
