#pragma once

#include <vector>

#include "protocols/reading/casting.hpp"

namespace bimodal::protocols {

/// Judges what the corpora of a cast have to say. Errors: words that a corpus lacks, or has only as
/// doubtful items. Warnings: words said with other phones than the list's, or with a pause within,
/// and a corpus whose words come from several talkers.
void judge_repertoire(const Cast& cast,
                      const std::vector<Word>& words,
                      const std::vector<Word>& practice,
                      Findings& findings);

}  // namespace bimodal::protocols
