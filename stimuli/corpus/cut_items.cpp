#include "stimuli/corpus/cut_items.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/audio/band.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/corpus/item_sound.hpp"

namespace bimodal {

namespace {

/// Difference of fits between takes that are equally good.
constexpr double kNearlyAsGood = 0.7;

double seconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

std::int64_t whole_milliseconds(Duration duration) {
  return std::chrono::round<std::chrono::milliseconds>(duration).count();
}

/// Between which times nothing but this word sounds.
SpeechInterval alone(const SaidWords& said, std::size_t index, Duration length) {
  const auto& word = said.words[index];
  SpeechInterval free{Duration{}, length};
  if (index > 0) free.start = said.words[index - 1].end();
  if (index + 1 < said.words.size()) free.end = said.words[index + 1].start();
  const auto middle = (word.start() + word.end()) / 2;
  for (const auto& other : said.others) {
    if (other.end <= middle) {
      free.start = std::max(free.start, other.end);
    } else {
      free.end = std::min(free.end, other.start);
    }
  }
  free.start = std::min(free.start, word.start());
  free.end = std::clamp(free.end, word.end(), std::max(length, word.end()));
  return free;
}

/// One end of an item: how far it is from the word, and what stands in its way.
std::vector<std::string> margin_doubts(const CorpusItem& item, bool running) {
  std::vector<std::string> doubts;
  const auto judge = [&](Duration margin, Duration clear, std::string_view where) {
    if (margin < kLeastMargin) {
      doubts.push_back(fmt::format(
          "the recording has only {} ms of sound {} it", whole_milliseconds(margin), where));
    } else if (clear < kLeastMargin && !running) {
      doubts.push_back(fmt::format(
          "another sound is {} ms {} it", whole_milliseconds(std::max(clear, Duration{})), where));
    }
  };
  const auto first = item.phones.front().start;
  const auto last = item.phones.back().end();
  const auto clear = item.clear.value_or(SpeechInterval{item.start, item.end});
  judge(first - item.start, first - clear.start, "before");
  judge(item.end - last, clear.end - last, "after");
  return doubts;
}

CorpusItem cut_item(const SaidWords& said, std::size_t index, const Clip& sound) {
  const auto& word = said.words[index];
  const auto length = std::max(sound.duration(), word.end());
  const auto free = alone(said, index, length);
  CorpusItem item{.name = word.word, .word = word.word, .phones = word.phones};
  const auto ease = [](Duration wanted, Duration least) { return std::max(wanted, least); };
  const auto before = ease(std::min(kMargin, word.start() - free.start), kLeastMargin);
  const auto after = ease(std::min(kMargin, free.end - word.end()), kLeastMargin);
  item.start = std::max(Duration{}, word.start() - before);
  item.end = std::min(length, word.end() + after);
  const SpeechInterval clear{std::max(item.start, free.start), std::min(item.end, free.end)};
  if (clear != SpeechInterval{item.start, item.end}) item.clear = clear;
  auto doubts = word.doubts;
  std::ranges::move(margin_doubts(item, said.running), std::back_inserter(doubts));
  const auto clipped = clipped_runs(cut(sound, {word.start(), std::min(word.end(), length)}));
  if (clipped > 0) {
    doubts.push_back(
        fmt::format("its sound is cut off at full scale in {}", counted(clipped, "place")));
  }
  item.doubt = fmt::format("{}", fmt::join(doubts, "; "));
  return item;
}

void doubt(CorpusItem& item, const std::string& why) {
  if (!item.doubt.empty()) item.doubt += "; ";
  item.doubt += why;
}

/// An item and how well its sound fits.
struct Take {
  CorpusItem item;
  double fit = 0.0;  ///< 0 where a hand labelled it
};

/// The last of the takes of a word that have no doubt and fit nearly as well as the best of these:
/// a cough after a word may be taken for the word, but fits worse.
std::size_t good_take(const std::vector<Take>& takes, const std::vector<std::size_t>& of_word) {
  double best = -HUGE_VAL;
  for (const auto take : of_word) {
    if (takes[take].item.doubt.empty()) best = std::max(best, takes[take].fit);
  }
  auto kept = of_word.back();
  for (const auto take : of_word) {
    if (takes[take].item.doubt.empty() && takes[take].fit >= best - kNearlyAsGood) kept = take;
  }
  return kept;
}

/// The good take stays without a doubt of its own, and goes before the others of its word.
std::vector<CorpusItem> with_takes_chosen(std::vector<Take> takes) {
  std::map<std::string, std::vector<std::size_t>> of_words;
  for (std::size_t i = 0; i < takes.size(); ++i) of_words[takes[i].item.word].push_back(i);
  std::vector<CorpusItem> items;
  for (const auto& first : takes) {
    auto& of_word = of_words[first.item.word];
    if (of_word.empty()) continue;
    const auto kept = good_take(takes, of_word);
    items.push_back(takes[kept].item);
    for (const auto take : of_word) {
      if (take == kept) continue;
      items.push_back(takes[take].item);
      doubt(items.back(),
            fmt::format("another take; the one at {:.2f} s is the item",
                        seconds(takes[kept].item.phones.front().start)));
    }
    of_word.clear();
  }
  return items;
}

}  // namespace

std::vector<CorpusItem> cut_items(const SaidWords& said,
                                  const Clip& sound,
                                  const std::function<bool(std::string_view)>& is_wanted) {
  std::vector<Take> takes;
  for (std::size_t i = 0; i < said.words.size(); ++i) {
    const auto& word = said.words[i];
    if (is_wanted(word.word)) takes.push_back({cut_item(said, i, sound), word.fit.value_or(0.0)});
  }
  if (!said.running) return with_takes_chosen(std::move(takes));
  std::vector<CorpusItem> items;
  for (auto& take : takes) items.push_back(std::move(take.item));
  return items;
}

}  // namespace bimodal
