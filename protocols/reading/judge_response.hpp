#pragma once

#include <vector>

#include "protocols/model/protocol.hpp"
#include "stimuli/base/findings.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal::protocols {

/// Whether answers fit the rest of the protocol: words that can be typed, enough time, a reaction
/// time that counts from something that every condition has. What is faulty by itself is not judged
/// again.
void judge_response(const Protocol& protocol, const std::vector<Word>& words, Findings& findings);

}  // namespace bimodal::protocols
