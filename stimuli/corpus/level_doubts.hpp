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

/// Doubts items that stand alone and are more than 12 dB from the median level of their talker's
/// items. Those of running speech are not judged: sentences end weaker than they begin.
void doubt_levels(std::span<BuiltRecording> recordings);

}  // namespace bimodal
