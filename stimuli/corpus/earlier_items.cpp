#include "stimuli/corpus/earlier_items.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace bimodal {

void name_items(Corpus& corpus) {
  std::set<std::string> used;
  for (auto& item : corpus.items) {
    auto name = item.word;
    for (int number = 2; used.contains(name); ++number) {
      name = fmt::format("{}-{}", item.word, number);
    }
    used.insert(name);
    item.name = std::move(name);
  }
}

void keep_verdicts(Corpus& corpus, const Corpus& earlier) {
  const auto near = [](Duration one, Duration other) {
    return std::chrono::abs(one - other) < std::chrono::milliseconds{1};
  };
  for (auto& item : corpus.items) {
    const auto& recording = corpus.recordings[item.recording];
    if (item.doubt.empty()) continue;
    const bool accepted = std::ranges::any_of(earlier.items, [&](const CorpusItem& before) {
      return !before.accepted.empty() && before.accepted == item.doubt &&
             before.word == item.word &&
             earlier.recordings[before.recording].sha256 == recording.sha256 &&
             near(before.start, item.start) && near(before.end, item.end) &&
             pronunciation_of(before) == pronunciation_of(item);
    });
    if (accepted) item.accepted = std::exchange(item.doubt, {});
  }
}

}  // namespace bimodal
