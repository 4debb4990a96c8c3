#include "stimuli/corpus/word_list_of.hpp"

#include <algorithm>
#include <iterator>
#include <set>

namespace bimodal {

WordList word_list_of(const Corpus& corpus) {
  WordList list{.name = corpus.name};
  std::set<std::string_view> taken;
  for (const auto& item : corpus.items) {
    if (!item.doubt.empty() || !taken.insert(item.word).second) continue;
    list.words.push_back({item.word, pronunciation_of(item)});
  }
  return list;
}

std::vector<std::string_view> symbols_of(std::span<const Phone> phones) {
  std::vector<std::string_view> symbols;
  for (const Phone phone : phones) symbols.push_back(symbol(phone));
  return symbols;
}

}  // namespace bimodal
