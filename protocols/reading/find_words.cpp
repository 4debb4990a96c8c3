#include "protocols/reading/find_words.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/json_text.hpp"
#include "stimuli/base/object_reader.hpp"
#include "stimuli/base/obstacle.hpp"

namespace bimodal::protocols {

namespace {

constexpr std::string_view kLibrary = "stimuli/assets/words";

bool is_path(std::string_view list) {
  return list.ends_with(".json") || list.find('/') != std::string_view::npos;
}

/// The file of a list that is named, not a path; noted and absent if the library has none.
std::optional<std::filesystem::path> file_in_library(const WordChoice& choice, Findings& findings) {
  try {
    const auto names = asset_names(kLibrary, ".json");
    if (std::ranges::find(names, choice.list) != names.end()) {
      return asset(fmt::format("{}/{}.json", kLibrary, choice.list));
    }
    const std::vector<std::string_view> known(names.begin(), names.end());
    findings.error(choice.pointer,
                   fmt::format("the library has no word list {}", shown(choice.list)),
                   suggestion(choice.list, known) +
                       "; for a list of your own give its path, which ends in .json");
  } catch (const std::exception& error) {
    findings.error(choice.pointer, "the library of word lists cannot be read", describe(error));
  }
  return std::nullopt;
}

}  // namespace

WordFinder::WordFinder(std::filesystem::path protocol_folder,
                       std::filesystem::path dictionary,
                       Findings& findings)
    : folder_{std::move(protocol_folder)},
      dictionary_file_{std::move(dictionary)},
      findings_{&findings} {}

std::vector<Word> WordFinder::find(const WordChoice& choice) {
  return choice.list.empty() ? look_up(choice) : read_list(choice);
}

const Dictionary* WordFinder::dictionary(std::string_view pointer) {
  if (!dictionary_ && !dictionary_failed_) {
    try {
      dictionary_.emplace(dictionary_file_.empty() ? Dictionary::installed() : dictionary_file_);
    } catch (const std::exception& error) {
      dictionary_failed_ = true;
      findings_->error(
          pointer, "the pronunciations of these words cannot be looked up", describe(error));
    }
  }
  return dictionary_ ? &*dictionary_ : nullptr;
}

std::optional<SpelledSegments> WordFinder::pronounce(const std::string& spelling,
                                                     const std::string& pointer) {
  const auto* dictionary = this->dictionary(pointer);
  if (dictionary == nullptr) return std::nullopt;
  const auto pronunciations = dictionary->pronunciations(spelling);
  if (!pronunciations.empty()) {
    return SpelledSegments{.phones = pronunciations.front(), .articulation = {}};
  }
  findings_->error(pointer,
                   fmt::format("{} has no pronunciation in the dictionary", shown(spelling)),
                   "check its spelling, or give its phones: "
                   "{ \"word\": \"ba\", \"phones\": [\"B\", \"AA\"] }");
  return std::nullopt;
}

std::vector<Word> WordFinder::look_up(const WordChoice& choice) {
  std::vector<Word> words;
  std::map<std::string, std::string> pointer_of;
  std::map<std::string, SpelledSegments> given;
  for (const auto& written : choice.words) {
    if (!written.said.phones.empty()) given.emplace(written.spelling, written.said);
  }
  const auto find_said = [&](const WrittenWord& written,
                             const std::string& spelling,
                             const SpelledSegments& said) -> std::optional<SpelledSegments> {
    if (!said.phones.empty()) return said;
    const auto found = given.find(spelling);
    return found != given.end() ? found->second : pronounce(spelling, written.pointer);
  };
  for (const auto& written : choice.words) {
    Word word{.spelling = written.spelling, .phones = {}, .seen = std::nullopt};
    if (!written.seen.empty() && written.seen != written.spelling) {
      word.seen = SeenWord{.spelling = written.seen, .phones = {}};
    }
    const auto [earlier, is_new] = pointer_of.emplace(shown_name(word), written.pointer);
    if (!is_new) {
      findings_->error(written.pointer,
                       fmt::format("{} is already at {}", shown(shown_name(word)), earlier->second),
                       "remove one of them");
      continue;
    }
    const auto said = find_said(written, word.spelling, written.said);
    if (!said) continue;
    word.phones = said->phones;
    word.articulation = said->articulation;
    if (word.seen) {
      const auto seen = find_said(written, word.seen->spelling, written.seen_said);
      if (!seen) continue;
      word.seen->phones = seen->phones;
      word.seen->articulation = seen->articulation;
    }
    words.push_back(std::move(word));
  }
  return words;
}

std::vector<Word> WordFinder::read_list(const WordChoice& choice) {
  auto file = is_path(choice.list) ? std::optional{folder_ / choice.list}
                                   : file_in_library(choice, *findings_);
  if (!file) return {};
  if (const auto reason = obstacle(*file)) {
    findings_->error(choice.pointer,
                     fmt::format("cannot read the word list '{}': {}", file->string(), *reason),
                     "give a path relative to the protocol, or the name of a list of the library");
    return {};
  }
  try {
    std::vector<Diagnostic> found;
    auto list = read_word_list(*file, found);
    if (has_errors(found)) {
      findings_->error(choice.pointer,
                       fmt::format("the word list '{}' has mistakes", file->string()),
                       "mend them; they are listed too");
    }
    list_findings_.insert(list_findings_.end(), found.begin(), found.end());
    for (const auto& word : list.words) {
      if (!word.phones.empty() || has_errors(found)) continue;
      findings_->error(
          choice.pointer,
          fmt::format("{} in '{}' has no phones", shown(word.spelling), file->string()),
          "add its pronunciation");
    }
    return std::move(list.words);
  } catch (const std::exception& error) {
    findings_->error(choice.pointer, "the word list cannot be read", describe(error));
    return {};
  }
}

}  // namespace bimodal::protocols
