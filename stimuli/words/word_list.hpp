#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stimuli/base/diagnostic.hpp"
#include "stimuli/timeline/phone.hpp"

namespace bimodal {

/// One item of an identification experiment.
struct Word {
  std::string spelling;  ///< lower case
  Pronunciation phones;

  bool operator==(const Word&) const = default;
};

struct WordList {
  std::string name;  ///< as the protocol names it
  std::vector<Word> words;
};

/// Reads `{"words": [{"word": "stew", "phones": ["S", "T", "UW"]}, ...]}`. Appends every mistake
/// (not JSON, unknown phone, missing key, doubled word, no words) to `diagnostics`, and returns
/// what could be read.
[[nodiscard]] WordList read_word_list(const std::filesystem::path& file,
                                      std::vector<Diagnostic>& diagnostics);

}  // namespace bimodal
