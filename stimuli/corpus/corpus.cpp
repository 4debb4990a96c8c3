#include "stimuli/corpus/corpus.hpp"

#include <algorithm>

namespace bimodal {

const CorpusItem* find_item(const Corpus& corpus, std::string_view word) {
  const auto found = std::ranges::find_if(corpus.items, [word](const CorpusItem& item) {
    return item.word == word && item.doubt.empty();
  });
  return found == corpus.items.end() ? nullptr : &*found;
}

Utterance utterance_of(const CorpusItem& item) {
  Utterance utterance;
  const auto rest = [&utterance](Duration start, Duration end) {
    if (end > start) utterance.phones.push_back({Phone::Rest, start, end - start});
  };
  if (item.phones.empty()) {
    rest(Duration{}, item.end - item.start);
    return utterance;
  }
  rest(Duration{}, item.phones.front().start - item.start);
  for (const auto& phone : item.phones) {
    utterance.phones.push_back({phone.phone, phone.start - item.start, phone.duration});
  }
  rest(item.phones.back().end() - item.start, item.end - item.start);
  return utterance;
}

Pronunciation pronunciation_of(const CorpusItem& item) {
  Pronunciation phones;
  for (const auto& phone : item.phones) {
    if (phone.phone != Phone::Rest) phones.push_back(phone.phone);
  }
  return phones;
}

std::filesystem::path media_file(const Corpus& corpus, std::size_t recording) {
  return corpus.folder / corpus.recordings.at(recording).file;
}

}  // namespace bimodal
