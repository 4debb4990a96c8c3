#pragma once

#include <span>

#include "stimuli/alignment/aligner.hpp"
#include "stimuli/audio/clip.hpp"
#include "stimuli/corpus/said_word.hpp"

namespace bimodal {

/// Where each word of a known text stands in a recording of running speech (Aligner, all words at
/// once); a text of one word stands alone. Throws Error as Aligner::align does.
[[nodiscard]] SaidWords hear_text(const Clip& sound, std::span<const SpokenWord> text);

/// A word and where somebody says that it stands.
struct PlacedWord {
  SpokenWord word;
  Duration start{};
  Duration end{};
};

/// The phones within words whose places are known and kept: each word is aligned by itself. Throws
/// Error, naming the word and its place, if it is too short for its phones or silent.
[[nodiscard]] SaidWords hear_placed(const Clip& sound, std::span<const PlacedWord> words);

}  // namespace bimodal
