#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/scoring/scoring_rules.hpp"
#include "stimuli/timeline/phone.hpp"

namespace bimodal::analysis {

/// What a stimulus phone is aligned with: a phone of the answer, or nothing.
using Partner = std::optional<Phone>;

/// In how many of the best alignments a stimulus phone has a partner.
struct PartnerCount {
  Partner partner;
  double alignments = 0.0;

  bool operator==(const PartnerCount&) const = default;
};

/// How the phones of an answer lie along those of the stimulus, over *all* best alignments. Best is
/// the least cost of substitutions, deletions and insertions (vowels stand only against vowels,
/// consonants only against consonants; Sankoff & Kruskal's sequence comparison); among these the
/// most matches; among these the fewest insertions, which says something only if substitutions do
/// not cost 1. Deletions and insertions cost 1. An alignment is which phones stand against each
/// other: in what order the others are deleted and inserted makes no other alignment.
struct Alignment {
  double cost = 0.0;
  int matches = 0;  ///< stimulus phones that are in the answer
  int insertions = 0;
  double alignments = 1.0;  ///< how many are best; exact up to 2^53
  /// For every stimulus phone the different partners that it has in the best alignments, in
  /// ascending order, nothing first. More than one: the answer does not tell which. Their counts
  /// sum to `alignments`.
  std::vector<std::vector<PartnerCount>> partners;
};

[[nodiscard]] Alignment align(std::span<const Phone> stimulus,
                              std::span<const Phone> answer,
                              AlignmentCosts costs = AlignmentCosts::Unit);

/// The best alignments with any of an answer's pronunciations.
struct AlignmentWithAny {
  struct Best {
    std::size_t pronunciation = 0;  ///< which
    double alignments = 0.0;        ///< how many of the best are with this one
  };

  Alignment alignment;     ///< of all that are equally good, taken together
  std::vector<Best> best;  ///< at least one
};

/// `answers` is not empty.
[[nodiscard]] AlignmentWithAny align_with_any(std::span<const Phone> stimulus,
                                              std::span<const Pronunciation> answers,
                                              AlignmentCosts costs = AlignmentCosts::Unit);

}  // namespace bimodal::analysis
