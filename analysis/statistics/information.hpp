#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {

/// What a confusion matrix says of how much of the stimuli came through, in bits, from the
/// proportions as they were observed (maximum likelihood; Miller & Nicely, 1955, J. Acoust. Soc.
/// Am. 27, 338-352).
struct Information {
  double responses = 0.0;         ///< n
  double stimulus_entropy = 0.0;  ///< H(x), of the stimuli as they were presented
  double response_entropy = 0.0;  ///< H(y)
  double joint_entropy = 0.0;     ///< H(x, y)
  /// T(x; y) = H(x) + H(y) - H(x, y), from 0 to either entropy. Of few responses it is too large:
  /// by chance alone some stimuli seem to come through.
  double transmitted = 0.0;
  std::optional<double> relative;  ///< T / H(x); absent where all stimuli are the same
  /// T, corrected by Miller & Madow's formula for each of the three entropies: T + (Kx + Ky - Kxy -
  /// 1) / (2 n ln 2), where K counts what occurred. Too large still where cells that are possible
  /// did not occur: of very few responses it even adds, and may be above H(x). May be below 0.
  double miller_madow = 0.0;
  /// T - (r - 1)(c - 1) / (2 n ln 2) of the r rows and c columns that occurred (Miller, 1955, in
  /// Quastler, ed., Information Theory in Psychology, 95-100):
  /// nearly right where every cell is possible, and too small by far where most are not. May be
  /// below 0.
  double all_cells_possible = 0.0;
};

/// Absent without responses.
[[nodiscard]] std::optional<Information> information(const ConfusionMatrix& matrix);

/// The matrix of what stimuli and responses belong to: counts of the same two groups are added.
/// `stimulus_groups` and `response_groups` name the group of every row and column; those whose name
/// is empty are left out. Groups come in the order in which they are met first.
[[nodiscard]] ConfusionMatrix grouped(const ConfusionMatrix& matrix,
                                      const std::vector<std::string>& stimulus_groups,
                                      const std::vector<std::string>& response_groups);

}  // namespace bimodal::analysis
