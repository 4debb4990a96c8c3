#include "stimuli/corpus/labelled_words.hpp"

#include <algorithm>
#include <optional>

#include <fmt/ranges.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/lower_case.hpp"
#include "stimuli/corpus/hear_text.hpp"
#include "stimuli/corpus/word_list_of.hpp"

namespace bimodal {

namespace {

using namespace std::chrono_literals;

constexpr Duration kForgiven = 100ms;
constexpr Duration kTouching = 60ms;
constexpr Duration kSameEdge = 5ms;

double seconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

/// The word's index under which most of a phone lies; absent if it lies under none.
std::optional<std::size_t> word_over(const TimedPhone& timed, std::span<const Label> words) {
  std::optional<std::size_t> most;
  Duration longest{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto common = std::min(words[i].end, timed.end()) - std::max(words[i].start, timed.start);
    if (common <= longest) continue;
    longest = common;
    most = i;
  }
  return most;
}

/// Which of a recording's phones are a word's.
struct PhonesOfWord {
  std::size_t first = 0;
  std::size_t end = 0;  ///< one past the last

  [[nodiscard]] bool empty() const { return first == end; }
};

std::vector<PhonesOfWord> share_out(std::span<const TimedPhone> phones,
                                    std::span<const Label> words) {
  std::vector<PhonesOfWord> shares(words.size());
  for (std::size_t i = 0; i < phones.size(); ++i) {
    if (phones[i].phone == Phone::Rest || phones[i].duration <= Duration{}) continue;
    const auto word = word_over(phones[i], words);
    if (!word) continue;
    auto& share = shares[*word];
    if (share.empty()) share.first = i;
    share.end = i + 1;
  }
  return shares;
}

std::string place(std::string_view symbol, Duration start, Duration end) {
  return fmt::format("{} ({:.3f} to {:.3f} s)", symbol, seconds(start), seconds(end));
}

/// Where the tiers of words and of phones disagree about a word.
std::vector<std::string> disagreements(const SaidWord& word,
                                       const PhonesOfWord& share,
                                       std::span<const TimedPhone> phones,
                                       std::span<const Label> words,
                                       const Label& label) {
  std::vector<std::string> doubts;
  const auto differ = [](Duration one, Duration other) {
    return std::chrono::abs(one - other) > kSameEdge;
  };
  if (differ(word.start(), label.start) || differ(word.end(), label.end)) {
    doubts.push_back(fmt::format(
        "its label is {}, its phones are {:.3f} to {:.3f} s: these count, make both tiers agree",
        place(fmt::format("\"{}\"", label.text), label.start, label.end),
        seconds(word.start()),
        seconds(word.end())));
  }
  const auto doubt_stray = [&](std::size_t index) {
    if (index >= phones.size()) return;
    const auto& timed = phones[index];
    if (timed.phone == Phone::Rest || word_over(timed, words)) return;
    doubts.push_back(fmt::format("the phone {} beside it lies under no word, so it is left out",
                                 place(symbol(timed.phone), timed.start, timed.end())));
  };
  if (share.first > 0) doubt_stray(share.first - 1);
  doubt_stray(share.end);
  return doubts;
}

std::optional<std::string> other_phones_than_listed(const SaidWord& word,
                                                    std::span<const Word> list) {
  const auto listed = std::ranges::find(list, word.word, &Word::spelling);
  if (listed == list.end()) return std::nullopt;
  Pronunciation spoken;
  for (const auto& timed : word.phones) {
    if (timed.phone != Phone::Rest) spoken.push_back(timed.phone);
  }
  if (spoken == listed->phones) return std::nullopt;
  return fmt::format("its phones are {}, those of the list {}",
                     fmt::join(symbols_of(spoken), " "),
                     fmt::join(symbols_of(listed->phones), " "));
}

SaidWords as_they_stand(const Tier& words,
                        const Tier& phones,
                        Duration length,
                        std::span<const Word> list) {
  const auto utterance = utterance_of(phones, length);
  std::vector<Label> labels;
  std::ranges::copy_if(words.labels, std::back_inserter(labels), [](const Label& label) {
    return !is_silence(label.text);
  });
  const auto shares = share_out(utterance.phones, labels);
  SaidWords said;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (shares[i].empty()) {
      throw Error{
          fmt::format("the word \"{}\" at {:.3f} s has no phones under it; label them, or "
                      "remove the tier of phones to have all of them found",
                      labels[i].text,
                      seconds(labels[i].start))};
    }
    const auto own =
        std::span{utterance.phones}.subspan(shares[i].first, shares[i].end - shares[i].first);
    SaidWord word{.word = lower_case(labels[i].text), .phones = {own.begin(), own.end()}};
    word.doubts = disagreements(word, shares[i], utterance.phones, labels, labels[i]);
    if (auto doubt = other_phones_than_listed(word, list)) word.doubts.push_back(*doubt);
    said.words.push_back(std::move(word));
  }
  return said;
}

SaidWords phones_found(const Tier& words, const Clip& sound, Pronouncer& pronouncer) {
  std::vector<PlacedWord> placed;
  std::vector<SpeechInterval> unknown;
  for (const auto& label : words.labels) {
    if (is_silence(label.text)) continue;
    if (const auto word = pronouncer.find(lower_case(label.text))) {
      placed.push_back({*word, label.start, std::min(label.end, sound.duration())});
    } else {
      unknown.push_back({label.start, label.end});
    }
  }
  auto said = hear_placed(sound, placed);
  said.others = std::move(unknown);
  return said;
}

SaidWords words_found(const Tier& phones, Duration length, std::span<const Word> list) {
  SaidWords said;
  std::vector<TimedPhone> stretch;
  const auto finish = [&] {
    if (stretch.empty()) return;
    Pronunciation spoken;
    std::ranges::transform(stretch, std::back_inserter(spoken), &TimedPhone::phone);
    const auto word = std::ranges::find(list, spoken, &Word::phones);
    if (word == list.end()) {
      said.others.push_back({stretch.front().start, stretch.back().end()});
    } else {
      said.words.push_back({.word = word->spelling, .phones = stretch});
    }
    stretch.clear();
  };
  for (const auto& timed : utterance_of(phones, length).phones) {
    if (timed.phone == Phone::Rest) {
      finish();
    } else {
      stretch.push_back(timed);
    }
  }
  finish();
  return said;
}

bool mostly_touching(const std::vector<SaidWord>& words) {
  std::size_t touching = 0;
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i].start() - words[i - 1].end() < kTouching) ++touching;
  }
  return 2 * touching >= words.size() && touching > 0;
}

void refuse_beyond(const Tier& tier, Duration length) {
  for (const auto& label : tier.labels) {
    if (is_silence(label.text) || label.end <= length + kForgiven) continue;
    throw Error{
        fmt::format("the label \"{}\" of the tier \"{}\" ends at {:.3f} s, but the sound "
                    "lasts {:.3f} s; are these the labels of this recording?",
                    label.text,
                    tier.name,
                    seconds(label.end),
                    seconds(length))};
  }
}

/// The tier, what is silent left out and what reaches beyond the sound cut.
Tier within(const Tier& tier, Duration length) {
  Tier cut{.name = tier.name};
  for (auto label : tier.labels) {
    label.end = std::min(label.end, length);
    if (label.start < label.end) cut.labels.push_back(std::move(label));
  }
  return cut;
}

}  // namespace

SaidWords labelled_words(const Labels& labels,
                         const Clip& sound,
                         std::span<const Word> list,
                         Pronouncer& pronouncer) {
  const auto length = sound.duration();
  const auto* const words = word_tier(labels);
  const auto* const phones = phone_tier(labels);
  if (words == nullptr && phones == nullptr) {
    throw Error{
        "there is no tier of words or phones among the labels; name one \"words\" and, if "
        "there are any, the other \"phones\""};
  }
  if (words != nullptr) refuse_beyond(*words, length);
  if (phones != nullptr) refuse_beyond(*phones, length);
  SaidWords said;
  if (words != nullptr && phones != nullptr) {
    said = as_they_stand(within(*words, length), within(*phones, length), length, list);
  } else if (words != nullptr) {
    said = phones_found(within(*words, length), sound, pronouncer);
  } else {
    said = words_found(within(*phones, length), length, list);
  }
  said.running = mostly_touching(said.words);
  return said;
}

Labels labels_of(const SaidWords& said, Duration length) {
  Utterance utterance;
  std::vector<Label> words;
  const auto rest_until = [&](Duration time) {
    if (time > utterance.end()) {
      utterance.phones.push_back({Phone::Rest, utterance.end(), time - utterance.end()});
    }
  };
  for (const auto& word : said.words) {
    rest_until(word.start());
    utterance.phones.insert(utterance.phones.end(), word.phones.begin(), word.phones.end());
    words.push_back({word.start(), word.end(), word.word});
  }
  rest_until(length);
  return labels_of(utterance, std::move(words));
}

}  // namespace bimodal
