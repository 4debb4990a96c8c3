#pragma once

#include <vector>

#include "stimuli/alignment/aligner.hpp"
#include "stimuli/corpus/said_word.hpp"

namespace bimodal {

/// Alignment::fit_of_word below which a word is doubted. Of Festival's words said as asked, 2 % of
/// one voice and none of another are below; of words taken for other ones of the same list, about
/// half.
inline constexpr double kPoorFit = -3.5;

/// The words of an alignment of a stretch that begins at `start` of the recording, with a doubt
/// wherever the fit is poor or a duration is one that people do not make: a vowel at the shortest
/// that the aligner can give, a phone above 0.7 s, a word above 1.5 s.
[[nodiscard]] std::vector<SaidWord> said_words(const Alignment& alignment, Duration start);

/// The doubts about durations alone.
[[nodiscard]] std::vector<std::string> duration_doubts(std::span<const TimedPhone> phones);

}  // namespace bimodal
