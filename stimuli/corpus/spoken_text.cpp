#include "stimuli/corpus/spoken_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/obstacle.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal {

namespace {

constexpr std::size_t kLongestText = 1'000'000;
constexpr std::size_t kMostWords = 5'000;
constexpr std::size_t kLongestWord = 100;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_blank(char letter) {
  return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r';
}

/// Letters, digits and everything beyond ASCII.
bool is_of_word(char letter) {
  const auto code = static_cast<unsigned char>(letter);
  return (code >= '0' && code <= '9') || (code >= 'A' && code <= 'Z') ||
         (code >= 'a' && code <= 'z') || code >= 0x80;
}

char lower(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

std::string content_of(const std::filesystem::path& file) {
  if (const auto reason = obstacle(file)) {
    throw Error{fmt::format("cannot read the text '{}': {}", file.string(), *reason)};
  }
  auto content = read_file(file);
  if (content.size() > kLongestText) {
    throw Error{
        fmt::format("cannot read the text '{}': {} bytes are more than the {} that we read; "
                    "give only what is said in the recording",
                    file.string(),
                    content.size(),
                    kLongestText)};
  }
  return content;
}

std::string_view without_mark(std::string_view text) {
  return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

}  // namespace

std::vector<std::string> words_of_text(std::string_view text, const std::string& source) {
  text = without_mark(text);
  const auto refuse = [&](const std::string& finding) {
    return Error{fmt::format("cannot read the text '{}': {}", source, finding)};
  };
  if (!is_utf8(text)) throw refuse("it is not UTF-8; save it as plain text in UTF-8");
  std::vector<std::string> words;
  std::string word;
  const auto finish = [&] {
    while (!word.empty() && !is_of_word(word.back())) word.pop_back();
    if (word.size() > kLongestWord) {
      throw refuse(fmt::format(
          "a word of {} letters; write what is said, with blanks between words", word.size()));
    }
    if (!word.empty()) words.push_back(word);
    word.clear();
    if (words.size() > kMostWords) {
      throw refuse(fmt::format("more than {} words; cut the recording into parts", kMostWords));
    }
  };
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (is_blank(letter)) {
      finish();
    } else if (code < ' ' || code == 0x7F) {
      throw refuse("it holds control characters; give plain text");
    } else if (is_of_word(letter)) {
      word += lower(letter);
    } else if (!word.empty() && (letter == '\'' || letter == '-')) {
      word += letter;
    } else {
      finish();
    }
  }
  finish();
  if (words.empty()) throw refuse("there are no words in it; write down what is said");
  return words;
}

std::vector<std::string> read_text(const std::filesystem::path& file) {
  return words_of_text(content_of(file), file.string());
}

std::map<std::string, std::vector<std::string>> read_texts(const std::filesystem::path& file) {
  return parse_texts(content_of(file), file.string());
}

std::map<std::string, std::vector<std::string>> parse_texts(std::string_view content,
                                                            const std::string& source) {
  content = without_mark(content);
  std::map<std::string, std::vector<std::string>> texts;
  std::size_t number = 0;
  while (!content.empty()) {
    const auto end = std::min(content.find('\n'), content.size());
    auto line = content.substr(0, end);
    content.remove_prefix(std::min(end + 1, content.size()));
    ++number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with('#') || std::ranges::all_of(line, is_blank)) continue;
    const auto at = fmt::format("{}:{}", source, number);
    const auto tab = line.find('\t');
    if (tab == std::string_view::npos || tab == 0) {
      throw Error{
          fmt::format("cannot read the text '{}': there is no tab between a recording's name "
                      "and its words; write e.g. \"sentence1<TAB>bin blue at f two now\"",
                      at)};
    }
    if (!is_utf8(line)) throw Error{fmt::format("cannot read the text '{}': not UTF-8", at)};
    const auto name = std::filesystem::path{line.substr(0, tab)}.stem().string();
    if (!texts.emplace(name, words_of_text(line.substr(tab + 1), at)).second) {
      throw Error{
          fmt::format("cannot read the text '{}': the recording '{}' stands twice; leave one "
                      "of the lines out",
                      at,
                      name)};
    }
  }
  return texts;
}

Pronouncer::Pronouncer(std::span<const Word> list) {
  for (const auto& word : list) list_.emplace(word.spelling, word.phones);
}

bool Pronouncer::is_listed(std::string_view word) const {
  return list_.find(word) != list_.end();
}

std::optional<SpokenWord> Pronouncer::find(const std::string& word) {
  if (const auto listed = list_.find(word); listed != list_.end()) {
    return SpokenWord{word, {listed->second}};
  }
  if (!dictionary_) dictionary_.emplace(Dictionary::installed());
  const auto known = dictionary_->pronunciations(word);
  if (known.empty()) return std::nullopt;
  return SpokenWord{word, {known.begin(), known.end()}};
}

SpokenWord Pronouncer::pronounce(const std::string& word) {
  if (auto known = find(word)) return *std::move(known);
  throw Error{
      fmt::format("nobody knows how \"{}\" is said: it is neither in the list nor in the "
                  "pronouncing dictionary; add it to the list with its phones",
                  word)};
}

}  // namespace bimodal
