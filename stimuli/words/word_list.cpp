#include "stimuli/words/word_list.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/json_line.hpp"

namespace bimodal {

namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 4> kListKeys{"name", "rule", "sources", "words"};
constexpr std::array<std::string_view, 2> kWordKeys{"word", "phones"};
constexpr std::string_view kWordRemedy = R"(write {"word": "stew", "phones": ["S", "T", "UW"]})";

/// Judges one file; every finding goes where the caller collects them.
class Reader {
 public:
  Reader(std::string file, std::string text, std::vector<Diagnostic>& diagnostics)
      : file_{std::move(file)}, text_{std::move(text)}, diagnostics_{diagnostics} {}

  WordList read() {
    WordList list;
    json root;
    try {
      root = json::parse(text_);
    } catch (const json::parse_error& error) {
      const std::size_t before = error.byte > 0 ? error.byte - 1 : 0;
      diagnostics_.push_back({.file = file_,
                              .line = line_of_offset(text_, before),
                              .pointer = {},
                              .finding = fmt::format("not JSON: {}", reason(error)),
                              .remedy = "mend the JSON at this place or just before it"});
      return list;
    }
    if (!root.is_object()) {
      find("", "a word list must be an object", R"(write {"words": [...]})");
      return list;
    }
    warn_of_unknown_keys(root, "", kListKeys);
    if (const auto name = root.find("name"); name != root.end()) {
      if (name->is_string()) {
        list.name = name->get<std::string>();
      } else {
        find("/name", fmt::format("{} is not a text", shown(*name)), "give the name in quotes");
      }
    }
    read_words(root, list.words);
    return list;
  }

 private:
  void read_words(const json& root, std::vector<Word>& words) {
    const auto found = root.find("words");
    if (found == root.end()) {
      find("", "there is no \"words\"", fmt::format("{} in an array named \"words\"", kWordRemedy));
      return;
    }
    if (!found->is_array() || found->empty()) {
      find("/words",
           found->is_array() ? "there are no words" : fmt::format("{} is no array", shown(*found)),
           fmt::format("{} in it, once for each word", kWordRemedy));
      return;
    }
    std::map<std::string, std::size_t> first_index;
    for (std::size_t index = 0; index < found->size(); ++index) {
      auto word = read_word((*found)[index], fmt::format("/words/{}", index));
      if (!word.has_value()) continue;
      const auto [first, is_new] = first_index.emplace(word->spelling, index);
      if (!is_new) {
        find(fmt::format("/words/{}/word", index),
             fmt::format("\"{}\" stands already at /words/{}", word->spelling, first->second),
             "leave one of the two out");
        continue;
      }
      words.push_back(std::move(*word));
    }
  }

  /// Absent if anything about the word is wrong.
  std::optional<Word> read_word(const json& entry, const std::string& at) {
    if (!entry.is_object()) {
      find(at, fmt::format("{} is no word", shown(entry)), std::string{kWordRemedy});
      return std::nullopt;
    }
    warn_of_unknown_keys(entry, at, kWordKeys);
    auto spelling = read_spelling(entry, at);
    auto phones = read_phones(entry, at);
    if (!spelling.has_value() || !phones.has_value()) return std::nullopt;
    return Word{std::move(*spelling), std::move(*phones)};
  }

  std::optional<std::string> read_spelling(const json& entry, const std::string& at) {
    const auto found = entry.find("word");
    if (found == entry.end()) {
      find(at, "there is no \"word\"", std::string{kWordRemedy});
      return std::nullopt;
    }
    const std::string pointer = at + "/word";
    if (!found->is_string() || found->get_ref<const std::string&>().empty()) {
      find(pointer, fmt::format("{} is no spelling", shown(*found)), std::string{kWordRemedy});
      return std::nullopt;
    }
    auto spelling = found->get<std::string>();
    const auto out_of_place = [](char letter) {
      const auto code = static_cast<unsigned char>(letter);
      return code <= ' ' || (code >= 'A' && code <= 'Z');
    };
    if (std::ranges::any_of(spelling, out_of_place)) {
      find(pointer,
           fmt::format("{} has a capital letter or a space", shown(*found)),
           "write one word in lower case");
      return std::nullopt;
    }
    return spelling;
  }

  std::optional<Pronunciation> read_phones(const json& entry, const std::string& at) {
    const auto found = entry.find("phones");
    if (found == entry.end()) {
      find(at, "there is no \"phones\"", std::string{kWordRemedy});
      return std::nullopt;
    }
    const std::string pointer = at + "/phones";
    if (!found->is_array() || found->empty()) {
      find(pointer,
           fmt::format("{} is no pronunciation", shown(*found)),
           R"(give the phones in an array, such as ["S", "T", "UW"])");
      return std::nullopt;
    }
    Pronunciation phones;
    for (std::size_t index = 0; index < found->size(); ++index) {
      const json& symbol = (*found)[index];
      const auto phone = symbol.is_string()
                             ? phone_from_symbol(symbol.get_ref<const std::string&>())
                             : std::nullopt;
      if (phone.has_value() && *phone != Phone::Rest) {
        phones.push_back(*phone);
      } else {
        find(fmt::format("{}/{}", pointer, index),
             fmt::format("{} is not a phone", shown(symbol)),
             fmt::format("use the symbols {}", spell(all_phones().subspan(1))));
      }
    }
    if (phones.size() < found->size()) return std::nullopt;
    return phones;
  }

  void warn_of_unknown_keys(const json& object,
                            const std::string& at,
                            std::span<const std::string_view> known) {
    for (const auto& [key, value] : object.items()) {
      if (std::ranges::find(known, key) != known.end()) continue;
      find(fmt::format("{}/{}", at, key),
           fmt::format("nothing reads \"{}\"", key),
           fmt::format("leave it out; known here are {}", fmt::join(known, ", ")),
           Severity::Warning);
    }
  }

  void find(const std::string& pointer,
            std::string finding,
            std::string remedy,
            Severity severity = Severity::Error) {
    diagnostics_.push_back({.severity = severity,
                            .file = file_,
                            .line = line_of_pointer(text_, pointer).value_or(0),
                            .pointer = pointer,
                            .finding = std::move(finding),
                            .remedy = std::move(remedy)});
  }

  /// A value as it may stand in a message: short, and valid UTF-8 whatever was read.
  static std::string shown(const json& value) {
    constexpr std::size_t kLongest = 40;
    if (value.is_object()) return "an object";
    if (value.is_array()) return value.empty() ? "an empty array" : "an array";
    std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
    if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
    return text;
  }

  /// The parser's own words without its number and place.
  static std::string reason(const json::parse_error& error) {
    const std::string_view what = error.what();
    const auto colon = what.find(": ");
    return std::string{colon == std::string_view::npos ? what : what.substr(colon + 2)};
  }

  std::string file_;
  std::string text_;
  std::vector<Diagnostic>& diagnostics_;
};

}  // namespace

WordList read_word_list(const std::filesystem::path& file, std::vector<Diagnostic>& diagnostics) {
  std::string text;
  try {
    text = read_file(file);
  } catch (const Error& error) {
    diagnostics.push_back({.severity = Severity::Error,
                           .file = file.string(),
                           .line = 0,
                           .pointer = {},
                           .finding = error.what(),
                           .remedy = "name an existing word list"});
    return {};
  }
  return Reader{file.string(), std::move(text), diagnostics}.read();
}

}  // namespace bimodal
