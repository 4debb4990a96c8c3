#pragma once

#include "stimuli/corpus/corpus.hpp"

namespace bimodal {

/// Names every item by its word, "stew", and a number from the second on, "stew-2".
void name_items(Corpus& corpus);

/// Takes the doubt from items that somebody has accepted in the earlier corpus in spite of the very
/// same doubt: of the same word with the same phones, in the same recording (SHA-256), the edges
/// within 1 ms.
void keep_verdicts(Corpus& corpus, const Corpus& earlier);

}  // namespace bimodal
