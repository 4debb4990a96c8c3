#pragma once

#include "stimuli/audio/clip.hpp"
#include "stimuli/corpus/said_word.hpp"
#include "stimuli/corpus/spoken_text.hpp"
#include "stimuli/labels/labels.hpp"

namespace bimodal {

/// The words of a recording that somebody has labelled; what the hand wrote is kept.
///   words and phones   used as they stand: a word has the phones that lie mostly in it. Where
///                      the two disagree the phones count, and the word is doubted: edges that
///                      differ by more than 5 ms, a phone beside it that lies under no word,
///                      phones of a word of the list that are not the list's
///   words only         their edges are kept, the phones are found within; a word that nobody knows
///                      how to say is among `others`
///   phones only        stretches between rests that are a word of the list to the phone; any other
///                      is among `others`
/// Words that mostly follow each other within 60 ms are taken for running speech. Throws Error if
/// there is neither tier, a label is no phone, a word of the list has no phones, or a word is
/// beyond the sound (0.1 s are forgiven) or too short for its phones.
[[nodiscard]] SaidWords labelled_words(const Labels& labels,
                                       const Clip& sound,
                                       std::span<const Word> list,
                                       Pronouncer& pronouncer);

/// Words and phones of a recording as tiers for Praat.
[[nodiscard]] Labels labels_of(const SaidWords& said, Duration length);

}  // namespace bimodal
