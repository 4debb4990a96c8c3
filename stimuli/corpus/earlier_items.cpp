#include "stimuli/corpus/earlier_items.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace bimodal {

namespace {

constexpr Duration kSamePlace = std::chrono::milliseconds{200};

double seconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

}  // namespace

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

std::vector<std::string> lost_words(const Corpus& corpus, const Corpus& earlier) {
  std::set<std::string> lost;
  for (const auto& item : earlier.items) lost.insert(item.word);
  for (const auto& item : corpus.items) lost.erase(item.word);
  return {lost.begin(), lost.end()};
}

std::vector<std::string> items_elsewhere(const Corpus& corpus, const Corpus& earlier) {
  std::vector<std::string> elsewhere;
  for (const auto& item : corpus.items) {
    const auto before = std::ranges::find(earlier.items, item.name, &CorpusItem::name);
    if (before == earlier.items.end()) continue;
    const auto& file = corpus.recordings[item.recording].file;
    const auto& file_before = earlier.recordings[before->recording].file;
    const bool is_same =
        file == file_before && std::chrono::abs(item.start - before->start) <= kSamePlace;
    if (is_same) continue;
    elsewhere.push_back(fmt::format("{} ({:.2f} s of {}, was {:.2f} s of {})",
                                    item.name,
                                    seconds(item.start),
                                    file,
                                    seconds(before->start),
                                    file_before));
  }
  return elsewhere;
}

}  // namespace bimodal
