#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/statistics/confusion_matrix.hpp"
#include "stimuli/base/random.hpp"

namespace bimodal::analysis {

/// What agreement can be expected of two matrices of the same face, with so few responses. Half of
/// the data is noisier than all of it (identical faces: r .86 of halves, .93 of all, with 80
/// responses a row), so halves are compared with halves: `within` with `across`.
struct NoiseCeiling {
  std::int64_t splits = 0;
  bool by_participants = false;  ///< halves of the participants, or else of the responses
  /// Mean Pearson correlation of the cells of one half of `one` with those of its other half.
  std::optional<double> within;
  /// The same of one half of `one` with the other half (other participants) of `other`.
  std::optional<double> across;
  std::optional<double> share;      ///< across / within; 1: as alike as one face is to itself
  std::optional<double> corrected;  ///< `within` at the full length (Spearman & Brown)
};

/// Halves of the responses to each stimulus, drawn at random; for independent responses. Matrices
/// with the same labels; parts of responses are rounded.
[[nodiscard]] NoiseCeiling noise_ceiling(const ConfusionMatrix& one,
                                         const ConfusionMatrix& other,
                                         bool off_diagonal_only,
                                         std::int64_t splits,
                                         Seed seed);

/// One participant's confusions in the two conditions, with the same labels for all.
struct ParticipantConfusions {
  ConfusionMatrix one;
  ConfusionMatrix other;
};

/// Halves of the participants, drawn at random; at least 4.
[[nodiscard]] NoiseCeiling noise_ceiling(std::span<const ParticipantConfusions> participants,
                                         bool off_diagonal_only,
                                         std::int64_t splits,
                                         Seed seed);

}  // namespace bimodal::analysis
