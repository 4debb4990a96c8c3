#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "stimuli/words/dictionary.hpp"

namespace bimodal::analysis {

/// How much of a lexicon can be told apart by eye, if phones of one class look the same: words
/// whose phones belong to the same classes in the same order are equivalent (Auer & Bernstein,
/// 1997, J. Acoust. Soc. Am. 102, 3704-3710).
struct LexicalEquivalence {
  std::size_t words = 0;    ///< spellings; each counts once, in its first pronunciation
  std::size_t classes = 0;  ///< of equivalent words
  std::size_t unique = 0;   ///< words alone in their class
  double unique_share = 0.0;
  double expected_size = 0.0;  ///< of the class of a word: sum of n_c^2 / N
  /// Entropy of the classes of that of the words, every word as likely as any other: information
  /// that is extracted (Carter, 1987, Comput. Speech Lang. 2, 1-11).
  double extracted = 0.0;
  std::size_t unique_by_sound = 0;  ///< words that have no homophone: the most that could be unique
};

/// `classes` lists the members of each class as symbols of phones, in any case; phones of no class
/// are alone in one. Labels that are no phones ("blank") are passed over. All 0 for an empty
/// dictionary.
[[nodiscard]] LexicalEquivalence lexical_equivalence(
    const Dictionary& dictionary, const std::vector<std::vector<std::string>>& classes);

}  // namespace bimodal::analysis
