#include "stimuli/corpus/labelled_words.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "stimuli/corpus/hear_text.hpp"
#include "stimuli/corpus/word_doubts.hpp"

namespace bimodal {

namespace {

using namespace std::chrono_literals;

constexpr Duration kForgiven = 100ms;
constexpr Duration kTouching = 60ms;

double seconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

std::string lower_case(std::string_view text) {
  std::string lower{text};
  std::ranges::transform(lower, lower.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return lower;
}

void trim_rests(std::vector<TimedPhone>& phones) {
  const auto is_rest = [](const TimedPhone& timed) {
    return timed.phone == Phone::Rest || timed.duration <= Duration{};
  };
  while (!phones.empty() && is_rest(phones.back())) phones.pop_back();
  phones.erase(phones.begin(), std::ranges::find_if_not(phones, is_rest));
}

std::vector<TimedPhone> phones_within(const Utterance& utterance, const Label& label) {
  std::vector<TimedPhone> phones;
  for (const auto& timed : utterance.phones) {
    const auto middle = timed.start + timed.duration / 2;
    if (middle >= label.start && middle < label.end) phones.push_back(timed);
  }
  trim_rests(phones);
  return phones;
}

SaidWords as_they_stand(const Tier& words, const Tier& phones, Duration length) {
  const auto utterance = utterance_of(phones, length);
  SaidWords said;
  for (const auto& label : words.labels) {
    if (is_silence(label.text)) continue;
    SaidWord word{.word = lower_case(label.text), .phones = phones_within(utterance, label)};
    if (word.phones.empty()) {
      throw Error{
          fmt::format("the word \"{}\" at {:.3f} s has no phones under it; label them, or "
                      "remove the tier of phones to have all of them found",
                      label.text,
                      seconds(label.start))};
    }
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
    said = as_they_stand(within(*words, length), within(*phones, length), length);
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
