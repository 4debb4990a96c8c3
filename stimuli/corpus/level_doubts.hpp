#pragma once

#include <span>
#include <string>
#include <vector>

#include "stimuli/base/quantity.hpp"
#include "stimuli/corpus/corpus.hpp"

namespace bimodal {

/// One recording's part of a corpus that is being built, before its items have names of their own.
struct BuiltRecording {
  Recording recording;
  std::vector<CorpusItem> items;
  std::vector<Decibels> levels;  ///< of the items' speech
  bool running = false;          ///< SaidWords::running
};

/// Doubts items that are more than 12 dB from the median level of their talker's items; words of
/// running speech, which ends weaker than it begins, only if they are more than 30 dB from it: what
/// somebody has labelled there is no speech.
void doubt_levels(std::span<BuiltRecording> recordings);

}  // namespace bimodal
