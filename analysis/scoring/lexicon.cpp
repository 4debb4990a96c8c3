#include "analysis/scoring/lexicon.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "analysis/scoring/spelling.hpp"
#include "stimuli/base/csv_reader.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/lower_case.hpp"
#include "stimuli/base/utf8.hpp"
#include "stimuli/timeline/phone_notation.hpp"

namespace bimodal::analysis {

namespace {

constexpr std::string_view kForm =
    "begin with the line word,phonemes and let lines like stew,S T UW follow";

std::size_t column_of(const std::vector<std::string>& header,
                      std::initializer_list<std::string_view> names,
                      const CsvReader& csv) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (std::ranges::find(names, lower_case(header[i])) != names.end()) return i;
  }
  csv.refuse(fmt::format("there is no column \"{}\"", *names.begin()), kForm);
}

/// Absent if any symbol is no ARPAbet.
std::optional<Pronunciation> read_arpabet(const std::string& text) {
  Pronunciation phones;
  std::istringstream symbols{text};
  for (std::string symbol; symbols >> symbol;) {
    const auto phone = phone_from_symbol(symbol);
    if (!phone || *phone == Phone::Rest) return std::nullopt;
    phones.push_back(*phone);
  }
  return phones;
}

Pronunciation read_phonemes(const std::string& text, const CsvReader& csv) {
  if (auto phones = read_arpabet(text)) return std::move(*phones);
  try {
    return read_phones(text, Notation::Ipa);
  } catch (const Error& fault) {
    csv.refuse(fmt::format("\"{}\" is neither ARPAbet with blanks between nor IPA", text),
               fmt::format("write phonemes like S T UW; as IPA: {}", fault.what()));
  }
}

}  // namespace

Dictionary parse_lexicon(std::string_view text, std::string_view file) {
  CsvReader csv{text, file};
  if (!is_utf8(text)) csv.refuse("the file is not UTF-8 text", "save it as CSV, UTF-8");
  const auto header = csv.next();
  if (!header) csv.refuse("the file is empty", kForm);
  const auto word = column_of(*header, {"word", "spelling"}, csv);
  const auto phonemes = column_of(*header, {"phonemes", "phones", "pronunciation"}, csv);
  std::vector<DictionaryEntry> entries;
  while (const auto fields = csv.next()) {
    if (fields->size() != header->size()) {
      csv.refuse(
          fmt::format("{} fields, but the first line has {}", fields->size(), header->size()),
          "write one for each column");
    }
    DictionaryEntry entry{.spelling = fold_spelling(fields->at(word)),
                          .phones = read_phonemes(fields->at(phonemes), csv)};
    if (entry.spelling.empty()) csv.refuse("the word has no letters", kForm);
    if (entry.phones.empty()) {
      csv.refuse(fmt::format("\"{}\" has no phonemes", fields->at(word)), kForm);
    }
    entries.push_back(std::move(entry));
  }
  if (entries.empty()) csv.refuse("there are no words after the first line", kForm);
  return Dictionary{std::move(entries)};
}

Dictionary read_lexicon(const std::filesystem::path& file) {
  return parse_lexicon(read_file(file), file.string());
}

Pronounced pronounce_stimuli(std::span<Trial> trials, const Dictionary& dictionary) {
  Pronounced counts;
  for (auto& trial : trials) {
    if (!trial.phones.empty()) {
      ++counts.known;
      continue;
    }
    const auto said = dictionary.pronunciations(fold_spelling(trial.word));
    if (said.empty()) {
      ++counts.lacking;
      continue;
    }
    ++counts.found;
    if (said.size() > 1) ++counts.ambiguous;
    trial.phones = said.front();
  }
  return counts;
}

}  // namespace bimodal::analysis
