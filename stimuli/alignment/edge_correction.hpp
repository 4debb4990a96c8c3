#pragma once

#include <vector>

#include "stimuli/alignment/search_sound.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

/// Moves edges that the acoustic model is known to misplace:
///   - An end of speech is put where the sound has died away: the last instant, up to 50 ms after
///     the edge, at which the level over 10 ms is within 35 dB of the highest since the last rest
///     (40 dB in obstruents other than voiced plosives, which end weakly) and 8 dB above the
///     lowest in the rest. The phone stays at least 30 ms long.
///   - After rest a voiceless plosive or affricate begins 30 ms earlier and a voiced one 10 ms,
///     because nothing is heard of its closure.
///   - From a nasal or glide to a vowel or obstruent the edge is 12 ms earlier, from a liquid to
///     these and from a vowel to a liquid 20 ms.
/// The amounts are round numbers that serve Festival's voices kal and slt alike, in either half of
/// the 414 words, and do no harm to natural speech; tests hold what they achieve.
///
/// `phones` are in order, with times in the recording; only their starts are used and changed, and
/// the order may be violated by what was too short.
void correct_edges(std::vector<TimedPhone>& phones, const SearchSound& sound);

}  // namespace bimodal
