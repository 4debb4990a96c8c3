#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/base/diagnostic.hpp"
#include "stimuli/timeline/segment.hpp"

namespace bimodal {

/// What a face says while something else is heard.
struct SeenWord {
  std::string spelling;  ///< lower case
  Pronunciation phones;
  std::vector<Segment> articulation = {};  ///< as in Word

  bool operator==(const SeenWord&) const = default;
};

/// One item of an identification experiment.
struct Word {
  std::string spelling;  ///< lower case
  Pronunciation phones;
  std::optional<SeenWord> seen;  ///< absent: what is seen is what is heard
  /// What a synthetic face does where sounds are ambiguous, "B~W:3/8 AA": as many segments as
  /// phones, which are the nearer ones. Empty: it does what the phones say.
  std::vector<Segment> articulation = {};

  bool operator==(const Word&) const = default;
};

struct WordList {
  std::string name;  ///< as the protocol names it
  std::vector<Word> words;
};

/// "ba", or "ba seen as da" for a dubbed one: how a word is named to people.
[[nodiscard]] std::string shown_name(const Word& word);

/// Reads `{"words": [{"word": "stew", "phones": ["S", "T", "UW"]}, ...]}`; phones may be ambiguous
/// segments, "B~W:3/8". A word to be dubbed onto another names it: `"seen": "da"`, one of the same
/// list, or spells it out: `"seen": {"word": "da", "phones": ["D", "AA"]}`. Appends every mistake
/// (not JSON, unknown phone, missing key, doubled word, no words) to `diagnostics`, and returns
/// what could be read.
[[nodiscard]] WordList read_word_list(const std::filesystem::path& file,
                                      std::vector<Diagnostic>& diagnostics);

}  // namespace bimodal
