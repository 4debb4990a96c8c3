#pragma once

#include "stimuli/audio/clip.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

/// When the first consonant of an utterance is released: the instant at which syllables with
/// different consonants are brought together for dubbing. That consonant is the last one before the
/// first vowel.
///
/// Of a plosive or affricate it is the burst: the steepest rise, over 5 ms, of the power above 1
/// kHz between the phone's start and 20 ms after its end (aligners place the end of a voiced
/// plosive some 10 ms behind the burst). Of any other consonant, and of a plosive that has no rise
/// of 6 dB, it is the start of the vowel. Without a consonant it is the start of the vowel, without
/// a vowel the start of the speech. Throws Error for an utterance that is all rest.
[[nodiscard]] Duration release_of(const Clip& sound, const Utterance& utterance);

}  // namespace bimodal
