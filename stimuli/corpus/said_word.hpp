#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

/// A word that was found in a recording.
struct SaidWord {
  std::string word;                 ///< lower case
  std::vector<TimedPhone> phones;   ///< on the recording's time, without gaps; at least one
  std::optional<double> fit;        ///< Alignment::fit_of_word; absent where a hand labelled it
  std::vector<std::string> doubts;  ///< each why somebody should look, in words for a phonetician

  [[nodiscard]] Duration start() const { return phones.front().start; }

  [[nodiscard]] Duration end() const { return phones.back().end(); }
};

/// All that was found in a recording.
struct SaidWords {
  std::vector<SaidWord> words;         ///< in order of time
  std::vector<SpeechInterval> others;  ///< sounds that are none of the words: coughs, comments
  /// Words of running speech touch each other, so that their margins cannot be silent; the words of
  /// a list stand alone.
  bool running = false;
};

}  // namespace bimodal
