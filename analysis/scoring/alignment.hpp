#pragma once

#include <optional>
#include <span>
#include <vector>

#include "stimuli/timeline/phone.hpp"

namespace bimodal::analysis {

/// What a stimulus phone is aligned with: a phone of the answer, or nothing.
using Partner = std::optional<Phone>;

/// How the phones of an answer lie along those of the stimulus, over *all* best alignments. Best is
/// the least number of substitutions, deletions and insertions (each costs 1; vowels stand only
/// against vowels, consonants only against consonants; Sankoff & Kruskal's sequence comparison),
/// and among these the most matches.
struct Alignment {
  int cost = 0;     ///< substitutions + deletions + insertions
  int matches = 0;  ///< stimulus phones that are in the answer
  /// For every stimulus phone the different partners that it has in the best alignments, in
  /// ascending order, nothing first. More than one: the answer does not tell which.
  std::vector<std::vector<Partner>> partners;
};

[[nodiscard]] Alignment align(std::span<const Phone> stimulus, std::span<const Phone> answer);

/// The best alignment with any of the answer's pronunciations (at least one); where several are
/// equally good, the partners of all of them.
[[nodiscard]] Alignment align_with_any(std::span<const Phone> stimulus,
                                       std::span<const Pronunciation> answers);

}  // namespace bimodal::analysis
