#pragma once

#include "stimuli/corpus/corpus.hpp"

namespace bimodal {

/// Names every item by its word, "stew", and a number from the second on, "stew-2".
void name_items(Corpus& corpus);

/// Takes the doubt from items on which somebody has given a verdict: of the same word with the same
/// phones, in the same recording (SHA-256), the edges within 1 ms, without a doubt in the earlier
/// corpus.
void keep_verdicts(Corpus& corpus, const Corpus& earlier);

}  // namespace bimodal
