#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include "stimuli/words/letter_rules.hpp"
#include "stimuli/words/pronounced_word.hpp"

namespace bimodal {

/// English spelling to phones by rule, for words that no dictionary has. The rules are those of
/// Elovitz, H. S., Johnson, R. W., McHugh, A. & Shore, J. E. (1976), Automatic translation of
/// English text to phonetics by means of letter-to-sound rules, NRL Report 7948, Naval Research
/// Laboratory, Washington.
///
/// At each place the first rule that matches wins and takes its letters away. Before, as in the
/// report, blanks are put around punctuation ("DON ' T"), on which the rules for apostrophes and
/// the ends of words rely, and every character that no rule can read becomes a blank. Digits are
/// read one by one. An apostrophe to which no rule applies is silent.
class LetterToSound {
 public:
  explicit LetterToSound(std::vector<LetterRule> rules);

  /// Reads the rules that the project ships. Throws Error, naming file and line of every mistake.
  [[nodiscard]] static LetterToSound shipped();

  /// The words of a text in any case, in order; none if it has neither letters nor digits. Words
  /// with a hyphen or apostrophe are one word.
  [[nodiscard]] std::vector<PronouncedWord> words(std::string_view text) const;

  /// The first rule that matches at a place of a text in capitals with blanks around punctuation
  /// and at both ends; null if there is none.
  [[nodiscard]] const LetterRule* rule_at(std::string_view text, std::size_t at) const;

  [[nodiscard]] const std::vector<LetterRule>& rules() const { return rules_; }

 private:
  std::vector<LetterRule> rules_;
  std::array<std::vector<std::size_t>, 128> by_first_letter_;  ///< indices into rules_
};

}  // namespace bimodal
