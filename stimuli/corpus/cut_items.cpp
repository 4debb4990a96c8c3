#include "stimuli/corpus/cut_items.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/audio/band.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/corpus/item_sound.hpp"

namespace bimodal {

namespace {

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

/// The last good take stays without a doubt of its own, and goes before the others of its word.
void choose_takes(std::vector<CorpusItem>& items) {
  for (std::size_t first = 0; first < items.size(); ++first) {
    std::vector<std::size_t> takes;
    for (std::size_t i = first; i < items.size(); ++i) {
      if (items[i].word == items[first].word) takes.push_back(i);
    }
    const bool seen = std::any_of(items.begin(),
                                  items.begin() + static_cast<std::ptrdiff_t>(first),
                                  [&](const auto& item) { return item.word == items[first].word; });
    if (seen || takes.size() < 2) continue;
    auto kept = takes.back();
    for (const auto take : takes) {
      if (items[take].doubt.empty()) kept = take;
    }
    for (const auto take : takes) {
      if (take == kept) continue;
      doubt(items[take],
            fmt::format("another take; the one at {:.2f} s is the item",
                        seconds(items[kept].phones.front().start)));
    }
    std::rotate(items.begin() + static_cast<std::ptrdiff_t>(first),
                items.begin() + static_cast<std::ptrdiff_t>(kept),
                items.begin() + static_cast<std::ptrdiff_t>(kept) + 1);
  }
}

}  // namespace

std::vector<CorpusItem> cut_items(const SaidWords& said,
                                  const Clip& sound,
                                  const std::function<bool(std::string_view)>& is_wanted) {
  std::vector<CorpusItem> items;
  for (std::size_t i = 0; i < said.words.size(); ++i) {
    if (is_wanted(said.words[i].word)) items.push_back(cut_item(said, i, sound));
  }
  if (!said.running) choose_takes(items);
  return items;
}

}  // namespace bimodal
