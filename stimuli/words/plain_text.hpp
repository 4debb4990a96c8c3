#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace bimodal {

/// The text with blanks for tabs and line ends, and with ' " - -- ... for typographic apostrophes,
/// quotation marks, hyphens, dashes and dots; all other characters stay. Throws Error if it is not
/// UTF-8, holds control characters, is longer than 100,000 bytes or has neither letters nor digits.
[[nodiscard]] std::string ascii_text(std::string_view text);

/// The text with nothing but what can be said in it: letters and digits, apostrophes and hyphens,
/// commas, full stops, question marks, "--" for a dash, blanks, and "(2)" right after a word, which
/// chooses its second pronunciation. ! is a full stop; ; : and other parentheses are commas;
/// quotation marks, brackets and slashes are blanks, also apostrophes that do not stand within a
/// word. Throws Error, naming the character and its place, if there is any other (letters of other
/// languages, signs such as %, which nobody can know how to say), if a word has more than 100
/// letters, or as ascii_text().
[[nodiscard]] std::string plain_text(std::string_view text);

/// A to Z in any case, and 0 to 9.
[[nodiscard]] bool is_letter(char letter);
[[nodiscard]] bool is_digit(char letter);

/// Whether a full stop or comma parts no words: between digits ("3.14", "10,000"), and after a
/// letter of an abbreviation that goes on ("U.S.A").
[[nodiscard]] bool parts_no_words(std::string_view text, std::size_t at);

/// How many characters "(2)", "(12)" has that begins at `at`; 0 if none begins there.
[[nodiscard]] std::size_t choice_length(std::string_view text, std::size_t at);

}  // namespace bimodal
