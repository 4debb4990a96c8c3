#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "analysis/data/trial.hpp"
#include "stimuli/words/dictionary.hpp"

namespace bimodal::analysis {

/// A lexicon as CSV: a column "word" (or "spelling") and a column "phonemes" (or "phones",
/// "pronunciation"), a line for each pronunciation, the most common of a word first; other columns
/// are not looked at. Phonemes are ARPAbet with blanks between ("S T UW1"), or IPA. Words are
/// folded (fold_spelling). Throws Error, naming file and line.
[[nodiscard]] Dictionary parse_lexicon(std::string_view text, std::string_view file);

/// The same of a file.
[[nodiscard]] Dictionary read_lexicon(const std::filesystem::path& file);

/// How many stimuli could be given phones, and how.
struct Pronounced {
  std::int64_t known = 0;      ///< had phones before
  std::int64_t found = 0;      ///< have those of the dictionary
  std::int64_t ambiguous = 0;  ///< of those found: the first of several pronunciations
  std::int64_t lacking = 0;    ///< not in the dictionary: they stay without phones
};

/// Looks up what trials present where they do not say how it is said.
Pronounced pronounce_stimuli(std::span<Trial> trials, const Dictionary& dictionary);

}  // namespace bimodal::analysis
