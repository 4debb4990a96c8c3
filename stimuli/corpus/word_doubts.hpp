#pragma once

#include <vector>

#include "stimuli/alignment/aligner.hpp"
#include "stimuli/corpus/said_word.hpp"

namespace bimodal {

/// The words of an alignment of a stretch that begins at `start` of the recording, with a doubt
/// wherever the fit is below kDoubtfulFit or a duration is one that people do not make: a vowel at
/// the shortest that the aligner can give, a phone above 0.7 s, a word above 1.5 s.
[[nodiscard]] std::vector<SaidWord> said_words(const Alignment& alignment, Duration start);

/// The doubts about durations alone.
[[nodiscard]] std::vector<std::string> duration_doubts(std::span<const TimedPhone> phones);

}  // namespace bimodal
