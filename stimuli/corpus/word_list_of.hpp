#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "stimuli/corpus/corpus.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal {

/// The words that a corpus can present: each word that has an item without doubt, once, with the
/// phones that find_item's has, in the order of the items; named like the corpus.
[[nodiscard]] WordList word_list_of(const Corpus& corpus);

/// {"S", "T", "UW"}.
[[nodiscard]] std::vector<std::string_view> symbols_of(std::span<const Phone> phones);

}  // namespace bimodal
