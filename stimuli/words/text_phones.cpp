#include "stimuli/words/text_phones.hpp"

#include <algorithm>
#include <charconv>
#include <string>

#include <fmt/format.h>

#include "stimuli/base/counted.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/lower_case.hpp"
#include "stimuli/words/number_words.hpp"
#include "stimuli/words/plain_text.hpp"

namespace bimodal {

namespace {

bool is_of_word(char letter) {
  return is_letter(letter) || is_digit(letter);
}

Pause pause_of(char mark) {
  switch (mark) {
    case '-':
      return Pause::Dash;
    case ',':
      return Pause::Comma;
    case '.':
      return Pause::Stop;
    case '?':
      return Pause::Question;
    default:
      return Pause::None;
  }
}

std::size_t digits_from(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && is_digit(text[end])) ++end;
  return end - at;
}

/// Whether the mark belongs to the number that ends before it: "1,000" or "3.5".
bool joins_number(std::string_view text, std::size_t begin, std::size_t at) {
  const auto number = text.substr(begin, at - begin);
  const auto following = digits_from(text, at + 1);
  const auto is_of_number = [](char letter) { return is_digit(letter) || letter == ','; };
  if (!std::ranges::all_of(number, is_of_number)) return false;
  return (text[at] == ',' && following == 3) || (text[at] == '.' && following > 0);
}

/// Goes through a plain text word by word.
class DictionaryReader {
 public:
  DictionaryReader(const Dictionary& dictionary, const LetterToSound& rules)
      : dictionary_{dictionary}, rules_{rules} {}

  std::vector<PronouncedWord> read(std::string_view plain) {
    for (std::size_t at = 0; at < plain.size();) {
      if (!is_of_word(plain[at])) {
        if (!words_.empty() && !parts_no_words(plain, at)) {
          words_.back().after = std::max(words_.back().after, pause_of(plain[at]));
        }
        ++at;
        continue;
      }
      const auto written = plain.substr(at, length_of_word(plain, at));
      at += written.size();
      const auto choice = plain.substr(at, choice_length(plain, at));
      at += choice.size();
      say(written, choice);
    }
    return std::move(words_);
  }

 private:
  static std::size_t length_of_word(std::string_view plain, std::size_t begin) {
    std::size_t at = begin;
    while (at < plain.size()) {
      const bool is_joint = (plain[at] == '\'' || plain[at] == '-') && at + 1 < plain.size() &&
                            is_of_word(plain[at + 1]);
      if (!is_of_word(plain[at]) && !is_joint && !joins_number(plain, begin, at)) break;
      ++at;
    }
    return at - begin;
  }

  void say(std::string_view written, std::string_view choice) {
    auto spelling = lower_case(written);
    if (const auto known = dictionary_.pronunciations(spelling); !known.empty()) {
      words_.push_back({.written = std::move(spelling),
                        .phones = known[place_of(choice, written, known.size())]});
      return;
    }
    if (!choice.empty()) {
      throw Error{
          fmt::format("the dictionary has no \"{}\", so \"{}{}\" chooses nothing; leave"
                      " the number out",
                      written,
                      written,
                      choice)};
    }
    if (const auto hyphen = written.find('-'); hyphen != std::string_view::npos) {
      say(written.substr(0, hyphen), {});
      say(written.substr(hyphen + 1), {});
    } else if (std::ranges::none_of(written, is_digit)) {
      for (auto& word : rules_.words(written)) words_.push_back(std::move(word));
    } else {
      say_number(written);
    }
  }

  /// Which pronunciation "(2)" means, counted from 0.
  static std::size_t place_of(std::string_view choice,
                              std::string_view written,
                              std::size_t count) {
    if (choice.empty()) return 0;
    std::size_t place = 0;
    std::from_chars(choice.data() + 1, choice.data() + choice.size() - 1, place);
    if (place >= 1 && place <= count) return place - 1;
    throw Error{
        fmt::format("the dictionary has {} of \"{}\", so \"{}{}\" chooses none of them;"
                    " write a number up to {}",
                    counted(count, "pronunciation"),
                    written,
                    written,
                    choice,
                    count)};
  }

  void say_number(std::string_view written) {
    std::string digits{written};
    std::erase(digits, ',');
    if (!std::ranges::all_of(digits, [](char c) { return is_digit(c) || c == '.'; })) {
      throw Error{
          fmt::format("nobody knows how \"{}\" is said, which mixes letters and digits;"
                      " write it in words, e.g. \"third\" for \"3rd\"",
                      written)};
    }
    for (const auto word : number_words(digits)) say(word, {});
  }

  const Dictionary& dictionary_;
  const LetterToSound& rules_;
  std::vector<PronouncedWord> words_;
};

}  // namespace

std::vector<PronouncedWord> phones_by_dictionary(std::string_view text,
                                                 const Dictionary& dictionary,
                                                 const LetterToSound& rules) {
  return DictionaryReader{dictionary, rules}.read(plain_text(text));
}

std::vector<PronouncedWord> phones_by_rules(std::string_view text, const LetterToSound& rules) {
  const auto plain = plain_text(text);
  if (const auto choice = plain.find('('); choice != std::string::npos) {
    throw Error{
        fmt::format("the letter-to-sound rules have one pronunciation of each word, so \"{}\" "
                    "chooses nothing; leave it out",
                    plain.substr(choice, choice_length(plain, choice)))};
  }
  auto words = rules.words(plain);
  if (std::ranges::all_of(words, [](const auto& word) { return word.phones.empty(); })) {
    throw Error{
        fmt::format("the letter-to-sound rules leave \"{}\" silent; write it as it is said, e.g. "
                    "\"aitch\", or use the dictionary",
                    text)};
  }
  return words;
}

}  // namespace bimodal
