#include "stimuli/words/plain_text.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal {

namespace {

constexpr std::size_t kLongestText = 100'000;
constexpr std::size_t kLongestWord = 100;
constexpr std::size_t kLongestChoice = 3;
constexpr std::string_view kSilent = "\"[]{}/\\";  ///< what is written and not said
constexpr std::string_view kKept = "-,.?";

struct Replacement {
  std::string_view written;
  std::string_view read;
};

constexpr std::array<Replacement, 17> kTypography{{
    {"\u2019", "'"},   // right single quotation mark, the typographic apostrophe
    {"\u2018", "'"},   // left single quotation mark
    {"\u02BC", "'"},   // modifier letter apostrophe
    {"\u201C", "\""},  // quotation marks
    {"\u201D", "\""},
    {"\u201E", "\""},
    {"\u00AB", "\""},
    {"\u00BB", "\""},
    {"\u2010", "-"},  // hyphens
    {"\u2011", "-"},
    {"\u2013", "--"},  // dashes
    {"\u2014", "--"},
    {"\u2026", "..."},
    {"\u00A0", " "},  // blanks that do not break
    {"\u202F", " "},
    {"\u00AD", ""},  // soft hyphen
    {"\uFEFF", ""},  // byte order mark
}};

[[noreturn]] void refuse(std::string_view finding, std::string_view remedy) {
  throw Error{fmt::format("reading the text: {}; {}", finding, remedy)};
}

bool is_of_word(std::string_view text, std::size_t at) {
  return at < text.size() && (is_letter(text[at]) || is_digit(text[at]));
}

/// Whether the character stands between two letters or digits.
bool is_within_word(std::string_view text, std::size_t at) {
  return at > 0 && is_of_word(text, at - 1) && is_of_word(text, at + 1);
}

/// The place of a byte as people count: in characters, from 1.
std::size_t place_of(std::string_view text, std::size_t at) {
  std::size_t place = 1;
  for (std::size_t i = 0; i < at; i += utf8_length(text, i)) ++place;
  return place;
}

[[noreturn]] void refuse_character(std::string_view text, std::size_t at) {
  const auto character = text.substr(at, utf8_length(text, at));
  const auto finding = fmt::format("nobody knows how \"{}\" is said, character {} of \"{}\"",
                                   character,
                                   place_of(text, at),
                                   text);
  const bool is_sign = character.size() == 1;
  refuse(finding,
         is_sign ? "write it as a word or leave it out" : "write the word with the letters A to Z");
}

/// What a character that is no part of a word is read as.
char mark_for(std::string_view text, std::size_t at) {
  const char written = text[at];
  if (kKept.find(written) != std::string_view::npos) return written;
  if (written == ' ' || written == '\'' || kSilent.find(written) != std::string_view::npos)
    return ' ';
  if (written == '!') return '.';
  if (written == ';' || written == ':' || written == '(' || written == ')') return ',';
  refuse_character(text, at);
}

void judge_lengths(std::string_view plain) {
  std::size_t length = 0;
  for (const char letter : plain) {
    length = letter == ' ' ? 0 : length + 1;
    if (length > kLongestWord) {
      refuse(fmt::format("a word has more than {} letters", kLongestWord),
             "put blanks between words");
    }
  }
}

/// Whether something may be a letter, if only of another language.
bool is_any_letter(char letter) {
  return is_letter(letter) || is_digit(letter) || static_cast<unsigned char>(letter) >= 0x80;
}

}  // namespace

bool is_letter(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
}

bool is_digit(char letter) {
  return letter >= '0' && letter <= '9';
}

bool parts_no_words(std::string_view text, std::size_t at) {
  const char mark = text[at];
  if ((mark != '.' && mark != ',') || at == 0 || at + 1 >= text.size()) return false;
  const char before = text[at - 1];
  const char after = text[at + 1];
  if (is_digit(before) && is_digit(after)) return true;
  const bool is_lone = at < 2 || (!is_letter(text[at - 2]) && !is_digit(text[at - 2]));
  return mark == '.' && is_letter(before) && is_lone && is_letter(after);
}

std::size_t choice_length(std::string_view text, std::size_t at) {
  if (at >= text.size() || text[at] != '(') return 0;
  std::size_t end = at + 1;
  while (end < text.size() && is_digit(text[end])) ++end;
  const bool is_choice = end > at + 1 && end - at <= kLongestChoice && text.substr(end, 1) == ")";
  return is_choice ? end + 1 - at : 0;
}

std::string ascii_text(std::string_view text) {
  if (text.size() > kLongestText) {
    refuse(fmt::format("{} bytes are more than the {} that we read", text.size(), kLongestText),
           "give it in parts");
  }
  if (!is_utf8(text)) refuse("it is not UTF-8", "save it as plain text in UTF-8");
  std::string ascii;
  for (std::size_t at = 0; at < text.size();) {
    const auto character = text.substr(at, utf8_length(text, at));
    at += character.size();
    const auto code = static_cast<unsigned char>(character.front());
    const auto* const known = std::ranges::find(kTypography, character, &Replacement::written);
    if (known != kTypography.end()) {
      ascii += known->read;
    } else if (character == "\t" || character == "\n" || character == "\r") {
      ascii += ' ';
    } else if (code < ' ' || code == 0x7F) {
      refuse("it holds control characters", "give plain text");
    } else {
      ascii += character;
    }
  }
  if (std::ranges::none_of(ascii, is_any_letter)) {
    refuse("there are no words in it", "give what is said, e.g. \"temporary food stew\"");
  }
  return ascii;
}

std::string plain_text(std::string_view text) {
  const auto ascii = ascii_text(text);
  std::string plain;
  for (std::size_t at = 0; at < ascii.size(); ++at) {
    const bool follows_word = at > 0 && is_of_word(ascii, at - 1);
    if (is_of_word(ascii, at) || (ascii[at] == '\'' && is_within_word(ascii, at))) {
      plain += ascii[at];
    } else if (const auto length = choice_length(ascii, at); follows_word && length > 0) {
      plain += ascii.substr(at, length);
      at += length - 1;
    } else {
      plain += mark_for(ascii, at);
    }
  }
  judge_lengths(plain);
  return plain;
}

}  // namespace bimodal
