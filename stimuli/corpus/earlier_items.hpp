#pragma once

#include <string>
#include <vector>

#include "stimuli/corpus/corpus.hpp"

namespace bimodal {

/// Names every item by its word, "stew", and a number from the second on, "stew-2".
void name_items(Corpus& corpus);

/// Takes the doubt from items that somebody has accepted in the earlier corpus in spite of the very
/// same doubt: of the same word with the same phones, in the same recording (SHA-256), the edges
/// within 1 ms.
void keep_verdicts(Corpus& corpus, const Corpus& earlier);

/// The words of the earlier corpus that the corpus has no longer, in alphabetical order.
[[nodiscard]] std::vector<std::string> lost_words(const Corpus& corpus, const Corpus& earlier);

/// Items whose name stood in the earlier corpus for another recording, or a place in it more than
/// 0.2 s away: data that are stored by the name would mean two things. Each as a text: "two (1.46 s
/// of media/b.mpg, was 1.64 s of media/a.mpg)".
[[nodiscard]] std::vector<std::string> items_elsewhere(const Corpus& corpus, const Corpus& earlier);

}  // namespace bimodal
