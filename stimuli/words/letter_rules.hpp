#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/timeline/phone.hpp"
#include "stimuli/words/pronounced_word.hpp"

namespace bimodal {

/// One letter-to-sound rule: these letters, between these contexts, are said so.
struct LetterRule {
  std::string name;           ///< its group and place in it: "A1", "PUNCT3"
  std::string left;           ///< made ready by context_before()
  std::string letters;        ///< capitals, digits or punctuation; never empty
  std::string right;          ///< made ready by context_after()
  Pronunciation phones;       ///< none: the letters are silent
  std::optional<Pause> ends;  ///< the pause of a rule that ends a word; absent: it does not
};

/// The punctuation that rules can read; a text's other characters mean nothing to them.
inline constexpr std::string_view kRulePunctuation = "'-,.?";

/// Reads a table of rules separated by tabs: the columns group, index, left, text, right, phonemes,
/// one rule a line, the first line their names. Blanks in the contexts count. The group is the
/// first letter of the text, or PUNCT or NUMBER; the index counts the rules of a group from 1.
/// Phonemes stand between slashes: "/AA R/", "/ /" for nothing, "/< >/" for the end of a word and
/// "/<->/",
/// "/<,>/", "/<.>/", "/<?>/" for pauses; the report's NX is NG. Every letter and digit must have a
/// rule without contexts. Throws Error, naming file and line of every mistake.
[[nodiscard]] std::vector<LetterRule> read_letter_rules(const std::filesystem::path& file);

/// The same, from the file's content.
[[nodiscard]] std::vector<LetterRule> parse_letter_rules(std::string_view content,
                                                         const std::string& file);

}  // namespace bimodal
