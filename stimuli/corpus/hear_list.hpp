#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "stimuli/audio/clip.hpp"
#include "stimuli/corpus/said_word.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal {

/// Told now and then how far a long work has come: what is done, and which part of it, 0 to 1.
/// Called by one thread at a time, not always the caller's.
using Progress = std::function<void(std::string_view deed, double part)>;

/// Finds the words of a list in a recording of somebody who reads them aloud in order, one after
/// the other with pauses between.
///
/// The chunks of speech are found by their level (find_speech), each is compared with the words
/// that may be due (WordListener; an interval around the diagonal, wider where numbers differ), and
/// the order of the list decides (match_list). Chunks that are left over are compared with the
/// words that are still missing. What is found is aligned (Aligner).
///
/// Doubted are words that sound more like another one, that stand out of order, or that hardly fit.
/// A word that is said several times is found several times. Two threads do the work. Throws Error
/// if there is no speech, or the list is empty or the two are too long for each other (over
/// 20 million pairs).
[[nodiscard]] SaidWords hear_list(const Clip& sound,
                                  std::span<const Word> list,
                                  const Progress& progress = {});

}  // namespace bimodal
