#pragma once

#include <optional>
#include <span>
#include <vector>

#include "stimuli/alignment/aligner.hpp"
#include "stimuli/alignment/phone_search.hpp"

namespace bimodal {

/// The words in order, each by any of its pronunciations: rest before and after, and wherever two
/// words meet rest or none.
[[nodiscard]] PhoneGrammar grammar_of(std::span<const SpokenWord> words);

/// Which part of a path is a word, and which pronunciation it has.
struct WordOnPath {
  std::size_t first = 0;  ///< index into the path
  std::size_t pronunciation = 0;
};

/// Reads a path through the grammar back: one entry a word. Absent if the path is not one from end
/// to end, every phone of every word in it.
[[nodiscard]] std::optional<std::vector<WordOnPath>> words_on(std::span<const FoundPhone> path,
                                                              std::span<const SpokenWord> words);

}  // namespace bimodal
