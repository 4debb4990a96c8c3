#pragma once

#include <vector>

#include "protocols/model/protocol.hpp"
#include "stimuli/base/findings.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal::protocols {

/// Judges what no key shows by itself: whether the parts of a protocol fit each other and its
/// words. Keys that are already known to be wrong, and words where none could be read, are not
/// judged again.
void judge_meaning(const Protocol& protocol,
                   const std::vector<Word>& words,
                   const std::vector<Word>& practice,
                   Findings& findings);

}  // namespace bimodal::protocols
