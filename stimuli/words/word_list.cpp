#include "stimuli/words/word_list.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "stimuli/words/judged_json.hpp"

namespace bimodal {

namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 4> kListKeys{"name", "rule", "sources", "words"};
constexpr std::array<std::string_view, 3> kWordKeys{"word", "phones", "seen"};
constexpr std::array<std::string_view, 2> kSeenKeys{"word", "phones"};
constexpr std::string_view kWordRemedy = R"(write {"word": "stew", "phones": ["S", "T", "UW"]})";

std::optional<std::string> read_spelling(const json& entry,
                                         const std::string& at,
                                         JudgedJson& judged) {
  auto spelling = judged.text_at(entry, at, "word", std::string{kWordRemedy});
  const auto out_of_place = [](char letter) {
    const auto code = static_cast<unsigned char>(letter);
    return code <= ' ' || (code >= 'A' && code <= 'Z');
  };
  if (spelling.has_value() && std::ranges::any_of(*spelling, out_of_place)) {
    judged.find(at + "/word",
                fmt::format("{} has a capital letter or a space", shown(*spelling)),
                "write one word in lower case");
    return std::nullopt;
  }
  return spelling;
}

std::optional<SpelledSegments> read_phones(const json& entry,
                                           const std::string& at,
                                           JudgedJson& judged) {
  const auto found = entry.find("phones");
  if (found == entry.end()) {
    judged.find(at, "there is no \"phones\"", std::string{kWordRemedy});
    return std::nullopt;
  }
  const std::string pointer = at + "/phones";
  if (!found->is_array() || found->empty()) {
    judged.find(pointer,
                fmt::format("{} is no pronunciation", shown(*found)),
                R"(give the phones in an array, such as ["S", "T", "UW"])");
    return std::nullopt;
  }
  std::vector<Segment> segments;
  for (std::size_t index = 0; index < found->size(); ++index) {
    const json& symbol = (*found)[index];
    const auto read = parse_sound(symbol.is_string() ? symbol.get_ref<const std::string&>() : "");
    if (const auto* const fault = std::get_if<SegmentFault>(&read)) {
      judged.find(
          fmt::format("{}/{}", pointer, index),
          symbol.is_string() ? fault->finding : fmt::format("{} is not a phone", shown(symbol)),
          fault->remedy);
    } else {
      segments.push_back(std::get<Segment>(read));
    }
  }
  if (segments.size() < found->size()) return std::nullopt;
  return spelled(segments);
}

/// {"word": "da", "phones": ["D", "AA"]} under "seen", or the name of a word of the list.
std::optional<SeenWord> read_seen(const json& entry, const std::string& at, JudgedJson& judged) {
  const json& seen = entry.at("seen");
  if (!seen.is_object()) {
    const std::string remedy{R"(name a word of this list, such as "seen": "da")"};
    auto spelling = judged.text_at(entry, at, "seen", remedy);
    if (!spelling) return std::nullopt;
    return SeenWord{.spelling = std::move(*spelling), .phones = {}};
  }
  const auto pointer = at + "/seen";
  judged.warn_of_unknown_keys(seen, pointer, kSeenKeys);
  auto spelling = read_spelling(seen, pointer, judged);
  auto said = read_phones(seen, pointer, judged);
  if (!spelling || !said) return std::nullopt;
  return SeenWord{.spelling = std::move(*spelling),
                  .phones = std::move(said->phones),
                  .articulation = std::move(said->articulation)};
}

/// Absent if anything about the word is wrong.
std::optional<Word> read_word(const json& entry, const std::string& at, JudgedJson& judged) {
  if (!entry.is_object()) {
    judged.find(at, fmt::format("{} is no word", shown(entry)), std::string{kWordRemedy});
    return std::nullopt;
  }
  judged.warn_of_unknown_keys(entry, at, kWordKeys);
  auto spelling = read_spelling(entry, at, judged);
  auto said = read_phones(entry, at, judged);
  if (!spelling.has_value() || !said.has_value()) return std::nullopt;
  Word word{.spelling = std::move(*spelling),
            .phones = std::move(said->phones),
            .seen = std::nullopt,
            .articulation = std::move(said->articulation)};
  if (entry.contains("seen")) {
    word.seen = read_seen(entry, at, judged);
    if (!word.seen) return std::nullopt;
    if (!word.seen->phones.empty() && word.seen->spelling == word.spelling) {
      judged.find(at + "/seen/word",
                  fmt::format("\"{}\" is the name of what is heard too", word.spelling),
                  "give what is seen a name of its own");
      return std::nullopt;
    }
  }
  return word;
}

/// Looks up the phones of what is seen.
void find_seen(std::vector<Word>& words, JudgedJson& judged) {
  std::map<std::string, SeenWord> known;
  for (const auto& word : words) {
    known.emplace(word.spelling, SeenWord{word.spelling, word.phones, word.articulation});
  }
  for (auto& word : words) {
    if (!word.seen || !word.seen->phones.empty()) continue;
    const auto found = known.find(word.seen->spelling);
    if (found == known.end()) {
      judged.find("/words",
                  fmt::format("\"{}\" is to be seen as \"{}\", which is not in the list",
                              word.spelling,
                              word.seen->spelling),
                  "add that word with its phones, or give them: "
                  "\"seen\": {\"word\": \"da\", \"phones\": [\"D\", \"AA\"]}");
    } else if (word.seen->spelling == word.spelling) {
      word.seen.reset();
    } else {
      word.seen = found->second;
    }
  }
}

std::vector<Word> read_words(const json& root, JudgedJson& judged) {
  const auto found = root.find("words");
  if (found == root.end()) {
    judged.find(
        "", "there is no \"words\"", fmt::format("{} in an array named \"words\"", kWordRemedy));
    return {};
  }
  if (!found->is_array() || found->empty()) {
    judged.find("/words",
                found->is_array() ? "there are no words" : shown(*found) + " is no array",
                fmt::format("{} in it, once for each word", kWordRemedy));
    return {};
  }
  std::vector<Word> words;
  std::map<std::string, std::size_t> first_index;
  for (std::size_t index = 0; index < found->size(); ++index) {
    auto word = read_word((*found)[index], fmt::format("/words/{}", index), judged);
    if (!word.has_value()) continue;
    const auto [first, is_new] = first_index.emplace(shown_name(*word), index);
    if (is_new) {
      words.push_back(std::move(*word));
    } else {
      judged.find(
          fmt::format("/words/{}/word", index),
          fmt::format("\"{}\" stands already at /words/{}", shown_name(*word), first->second),
          "leave one of the two out");
    }
  }
  find_seen(words, judged);
  return words;
}

}  // namespace

std::string shown_name(const Word& word) {
  if (!word.seen) return word.spelling;
  return fmt::format("{} seen as {}", word.spelling, word.seen->spelling);
}

WordList read_word_list(const std::filesystem::path& file, std::vector<Diagnostic>& diagnostics) {
  JudgedJson judged{file, diagnostics};
  const auto root = judged.parse();
  WordList list;
  if (!root.has_value()) return list;
  if (!root->is_object()) {
    judged.find("", "a word list must be an object", R"(write {"words": [...]})");
    return list;
  }
  judged.warn_of_unknown_keys(*root, "", kListKeys);
  if (root->contains("name")) {
    list.name = judged.text_at(*root, "", "name", "give the name in quotes").value_or("");
  }
  list.words = read_words(*root, judged);
  return list;
}

}  // namespace bimodal
