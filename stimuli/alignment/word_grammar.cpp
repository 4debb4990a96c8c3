#include "stimuli/alignment/word_grammar.hpp"

#include <algorithm>

namespace bimodal {

namespace {

constexpr PhoneToken kRest{};

bool is_rest(const FoundPhone& found) {
  return found.token == kRest;
}

}  // namespace

PhoneGrammar grammar_of(std::span<const SpokenWord> words) {
  PhoneGrammar grammar{.states = 2, .arcs = {{.from = 0, .to = 1, .token = kRest}}};
  std::size_t before = 1;
  for (const auto& word : words) {
    const std::size_t after = grammar.states++;
    for (const auto& phones : word.pronunciations) {
      std::size_t at = before;
      for (std::size_t i = 0; i < phones.size(); ++i) {
        const std::size_t next = i + 1 == phones.size() ? after : grammar.states++;
        grammar.arcs.push_back({at, next, PhoneToken{phones[i], i == 0}});
        at = next;
      }
    }
    before = grammar.states++;
    grammar.arcs.push_back({after, before, kRest});
    if (&word != &words.back()) grammar.arcs.push_back({after, before, std::nullopt});
  }
  return grammar;
}

std::optional<std::vector<WordOnPath>> words_on(std::span<const FoundPhone> path,
                                                std::span<const SpokenWord> words) {
  if (path.empty() || !is_rest(path.front()) || !is_rest(path.back())) return std::nullopt;
  std::vector<WordOnPath> read;
  std::size_t at = 0;
  for (const auto& word : words) {
    while (at < path.size() && is_rest(path[at])) ++at;
    const auto rest = path.subspan(at);
    const auto ends = std::find_if(rest.begin() + (rest.empty() ? 0 : 1), rest.end(), [](auto& it) {
      return is_rest(it) || it.token.begins_word;
    });
    const auto heard = rest.first(static_cast<std::size_t>(ends - rest.begin()));
    if (heard.empty() || !heard.front().token.begins_word) return std::nullopt;
    const auto said = std::ranges::find_if(word.pronunciations, [&](const Pronunciation& phones) {
      return std::ranges::equal(heard, phones, [](const FoundPhone& found, Phone phone) {
        return found.token.phone == modelled(phone);
      });
    });
    if (said == word.pronunciations.end()) return std::nullopt;
    read.push_back({at, static_cast<std::size_t>(said - word.pronunciations.begin())});
    at += heard.size();
  }
  const bool ended = std::ranges::all_of(path.subspan(at), is_rest);
  return ended ? std::optional{read} : std::nullopt;
}

}  // namespace bimodal
