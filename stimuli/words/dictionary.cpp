#include "stimuli/words/dictionary.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

constexpr std::string_view kInstalled = "/usr/share/pocketsphinx/model/en-us/cmudict-en-us.dict";
constexpr std::string_view kBlank = " \t\r";

/// phone_from_symbol() with a short cut for plain upper-case symbols, of which a whole dictionary
/// has hundreds of thousands.
class SymbolReader {
 public:
  SymbolReader() {
    table_.fill(Phone::Rest);
    for (const Phone phone : all_phones()) {
      if (is_plain(symbol(phone))) table_.at(place(symbol(phone))) = phone;
    }
  }

  std::optional<Phone> operator()(std::string_view symbol) const {
    if (is_plain(symbol)) {
      const Phone phone = table_.at(place(symbol));
      if (phone != Phone::Rest) return phone;
    }
    return phone_from_symbol(symbol);
  }

 private:
  static bool is_plain(std::string_view symbol) {
    return !symbol.empty() && symbol.size() <= 2 &&
           std::ranges::all_of(symbol, [](char letter) { return letter >= 'A' && letter <= 'Z'; });
  }

  static std::size_t place(std::string_view symbol) {
    const auto letter = [&](std::size_t i) { return static_cast<std::size_t>(symbol[i] - 'A'); };
    return 27 * letter(0) + (symbol.size() > 1 ? 1 + letter(1) : 0);
  }

  std::array<Phone, 26UL * 27UL> table_{};
};

/// Takes the first blank-separated part off a line; empty if there is none.
std::string_view take_part(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
  const auto part = line.substr(0, line.find_first_of(kBlank));
  line.remove_prefix(part.size());
  return part;
}

/// "read(2)" is "read".
std::string spelling_of(std::string_view headword) {
  if (headword.back() == ')') headword = headword.substr(0, headword.rfind('('));
  std::string spelling{headword};
  for (char& letter : spelling) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return spelling;
}

std::vector<DictionaryEntry> parse(std::string_view text, const std::string& file) {
  const auto fail = [&](std::size_t line, std::string_view finding) {
    throw Error{fmt::format(
        "{}:{}: reading the pronouncing dictionary: {}; each line must be a spelling and its"
        " phones, such as \"stew S T UW\"",
        file,
        line,
        finding)};
  };
  std::vector<DictionaryEntry> entries;
  entries.reserve(static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1);
  const SymbolReader phone_of;
  for (std::size_t number = 1; !text.empty(); ++number) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.starts_with(";;;") || line.starts_with("##")) continue;
    const auto headword = take_part(line);
    if (headword.empty()) continue;
    DictionaryEntry entry{spelling_of(headword), {}};
    if (entry.spelling.empty()) fail(number, "there is no spelling");
    entry.phones.reserve(line.size() / 2);
    for (auto symbol = take_part(line); !symbol.empty(); symbol = take_part(line)) {
      const auto phone = phone_of(symbol);
      if (!phone.has_value() || *phone == Phone::Rest) {
        fail(number, fmt::format("\"{}\" is not a phone", symbol));
      }
      entry.phones.push_back(*phone);
    }
    if (entry.phones.empty()) fail(number, fmt::format("\"{}\" has no phones", entry.spelling));
    entries.push_back(std::move(entry));
  }
  if (entries.empty()) fail(1, "the file has no words");
  return entries;
}

}  // namespace

Dictionary::Dictionary(const std::filesystem::path& file)
    : Dictionary{parse(read_file(file), file.string())} {}

Dictionary::Dictionary(std::vector<DictionaryEntry> entries) {
  std::vector<DictionaryEntry*> order;  // moving pointers about is quicker than moving entries
  order.reserve(entries.size());
  for (auto& entry : entries) order.push_back(&entry);
  std::ranges::stable_sort(order, {}, [](const DictionaryEntry* entry) -> const std::string& {
    return entry->spelling;
  });
  pronunciations_.reserve(entries.size());
  for (DictionaryEntry* entry : order) {
    if (spellings_.empty() || spellings_.back() != entry->spelling) {
      spellings_.push_back(std::move(entry->spelling));
      begins_.push_back(pronunciations_.size());
    }
    pronunciations_.push_back(std::move(entry->phones));
  }
  begins_.push_back(pronunciations_.size());
}

std::filesystem::path Dictionary::installed() {
  const char* chosen = std::getenv("BIMODAL_DICTIONARY");
  const std::filesystem::path file{chosen != nullptr ? std::string_view{chosen} : kInstalled};
  if (std::error_code ignored; !std::filesystem::exists(file, ignored)) {
    throw Error{fmt::format("looking for the pronouncing dictionary: there is no file '{}'; {}",
                            file.string(),
                            chosen != nullptr
                                ? "correct the environment variable BIMODAL_DICTIONARY, or unset it"
                                : "install the Debian package pocketsphinx-en-us, or set"
                                  " BIMODAL_DICTIONARY to a dictionary in CMU format")};
  }
  return file;
}

std::span<const Pronunciation> Dictionary::pronunciations(std::string_view spelling) const {
  const auto found = std::ranges::lower_bound(
      spellings_, spelling, {}, [](const auto& known) { return std::string_view{known}; });
  if (found == spellings_.end() || *found != spelling) return {};
  const auto at = static_cast<std::size_t>(found - spellings_.begin());
  return std::span{pronunciations_}.subspan(begins_[at], begins_[at + 1] - begins_[at]);
}

bool Dictionary::homophones(std::string_view one, std::string_view other) const {
  if (one == other) return true;
  const auto others = pronunciations(other);
  return std::ranges::any_of(pronunciations(one), [&](const Pronunciation& phones) {
    return std::ranges::find(others, phones) != others.end();
  });
}

std::span<const std::string> Dictionary::spellings() const {
  return spellings_;
}

bool is_one_syllable(std::span<const Phone> phones) {
  return std::ranges::count_if(phones, is_vowel) == 1;
}

}  // namespace bimodal
