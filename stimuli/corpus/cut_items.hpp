#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "stimuli/audio/clip.hpp"
#include "stimuli/corpus/corpus.hpp"
#include "stimuli/corpus/said_word.hpp"

namespace bimodal {

inline constexpr Duration kMargin = std::chrono::milliseconds{100};
inline constexpr Duration kLeastMargin = std::chrono::milliseconds{50};

/// Cuts the words that are wanted out of a recording, as items named like their words (not unique
/// yet), of recording 0, in the order of time.
///
/// An item has kMargin of the recording's own sound on either side of its word, as far as no other
/// word or sound begins there, but kLeastMargin in any case; where that holds a neighbour's speech,
/// `clear` says so. Of words that stand alone, that is doubted; of running speech it is the rule.
/// Doubted as well are a margin shortened by the recording's own ends, clipped sound, and, of words
/// that stand alone, all but one take of a word said several times: the last that has no doubt and
/// fits nearly as well as the best stays, and comes first.
[[nodiscard]] std::vector<CorpusItem> cut_items(
    const SaidWords& said,
    const Clip& sound,
    const std::function<bool(std::string_view)>& is_wanted);

}  // namespace bimodal
