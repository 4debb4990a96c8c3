#pragma once

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

}  // namespace bimodal
