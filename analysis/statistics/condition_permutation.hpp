#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "stimuli/base/random.hpp"

namespace bimodal::analysis {

/// One trial of the two conditions that are compared.
struct ComparedTrial {
  std::uint32_t participant = 0;  ///< index
  std::uint32_t item = 0;         ///< index of the word
  bool other = false;             ///< in the other condition (synthetic), not the one (natural)
  bool correct = false;           ///< as a whole
  /// Cells of the confusion matrix that it adds one to: stimulus x responses + response. Several if
  /// all phonemes count; none where the alignment is ambiguous.
  std::vector<std::uint32_t> cells;
};

/// What chance decided about a trial's condition, and so what a permutation may decide again.
enum class Randomisation {
  /// Participants met items in both conditions: labels are exchanged within participant x item.
  WithinItems,
  /// Each participant met each item once, all the same items: whose list of items had which
  /// condition is exchanged between participants, each participant's lists together.
  BetweenParticipants,
  /// The same, but participants met different lists in the two conditions (a Latin square of more
  /// conditions): labels are exchanged between the participants who met a list, list by list.
  WithinLists,
  /// Every item was met in one of the two conditions only: nothing can be exchanged.
  None,
};

/// "within-items", "between-participants", "within-lists", "none".
[[nodiscard]] std::string_view name(Randomisation randomisation);

struct ConditionPermutation {
  Randomisation randomisation = Randomisation::None;
  std::int64_t permutations = 0;
  std::int64_t used = 0;      ///< trials
  std::int64_t left_out = 0;  ///< trials whose item has no counterpart in the other condition
  /// log10 of how many different arrangements the design has; where they are few, p cannot be
  /// small.
  double log10_arrangements = 0.0;
  double chi_square = 0.0;           ///< observed: Pearson's, rows summed
  std::optional<double> p;           ///< of the chi-square; absent if nothing can be exchanged
  double accuracy_difference = 0.0;  ///< observed: other less one, proportion of trials correct
  std::optional<double> accuracy_p;  ///< two-sided
  std::vector<double> difference;    ///< of each cell: p(j|i) in one less that in other
  std::vector<std::optional<double>> cell_p;  ///< two-sided; absent where neither has a response
  std::vector<std::optional<double>> cell_q;  ///< cell_p at a false discovery rate
};

/// Whether two conditions' confusions differ: their observed difference against those when the
/// conditions are dealt again as the design dealt them (Edgington & Onghena, 2007, Randomization
/// Tests, 4th ed.). p = (1 + as large) / (1 + permutations). `stimuli` x `responses` is the size of
/// the matrix. The result is the same for any number of processors.
[[nodiscard]] ConditionPermutation permute_conditions(std::span<const ComparedTrial> trials,
                                                      std::size_t stimuli,
                                                      std::size_t responses,
                                                      std::int64_t permutations,
                                                      Seed seed);

}  // namespace bimodal::analysis
