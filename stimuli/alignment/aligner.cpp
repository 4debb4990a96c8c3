#include "stimuli/alignment/aligner.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/alignment/phone_search.hpp"
#include "stimuli/alignment/search_sound.hpp"
#include "stimuli/alignment/word_grammar.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

constexpr Duration kLongest = std::chrono::minutes{10};
constexpr Duration kShortestPhone = PhoneSearch::kFrame * PhoneSearch::kFewestFrames;

/// A frame hears 25.6 ms from its start; the edge between two lies between their centres.
constexpr Duration kShift = (PhoneSearch::kWindow - PhoneSearch::kFrame) / 2;

double milliseconds(Duration duration) {
  return std::chrono::duration<double, std::milli>{duration}.count();
}

/// What was asked for, for messages: "\"stew\" (S T UW)".
std::string named(std::span<const SpokenWord> words) {
  constexpr std::size_t kShown = 6;
  std::string text;
  for (const auto& word : words.first(std::min(words.size(), kShown))) {
    if (!text.empty()) text += ' ';
    const auto phones =
        word.pronunciations.empty() ? "no pronunciation" : spell(word.pronunciations.front());
    text += word.spelling.empty() ? phones : fmt::format("\"{}\" ({})", word.spelling, phones);
  }
  if (words.size() > kShown) text += fmt::format(" ... {} words", words.size());
  return text;
}

std::size_t fewest_phones(const SpokenWord& word) {
  return std::ranges::min_element(word.pronunciations, {}, &Pronunciation::size)->size();
}

void refuse_impossible_words(std::span<const SpokenWord> words) {
  if (words.empty()) throw Error{"aligning a recording: no words were given; give at least one"};
  for (const auto& word : words) {
    const auto faulty = [](const Pronunciation& phones) {
      return phones.empty() || std::ranges::count(phones, Phone::Rest) > 0;
    };
    if (word.pronunciations.empty() || std::ranges::any_of(word.pronunciations, faulty)) {
      throw Error{
          fmt::format("aligning {}: a pronunciation must be at least one phone, none of "
                      "them rest; rest is found by itself",
                      named(words))};
    }
  }
}

void refuse_impossible_length(const Clip& sound, std::span<const SpokenWord> words) {
  const auto length = sound.duration();
  if (length > kLongest) {
    throw Error{
        fmt::format("aligning {}: the recording lasts {:.1f} minutes, more than {}; cut it "
                    "into parts at pauses",
                    named(words),
                    milliseconds(length) / 60'000.0,
                    kLongest / std::chrono::minutes{1})};
  }
  std::size_t phones = 0;
  for (const auto& word : words) phones += fewest_phones(word);
  if (const auto needed = kShortestPhone * phones; length < needed) {
    throw Error{
        fmt::format("aligning {}: the recording lasts {:.0f} ms, but {} phones need at "
                    "least {:.0f} ms; give the whole recording, or fewer phones",
                    named(words),
                    milliseconds(length),
                    phones,
                    milliseconds(needed))};
  }
}

/// The free path's log likelihood from its first frame to any other.
class FreeScore {
 public:
  explicit FreeScore(std::span<const FoundPhone> path) : path_{path} {}

  /// Within a phone, the score is taken to be even.
  [[nodiscard]] double between(std::size_t first, std::size_t end) const {
    double sum = 0.0;
    for (const auto& found : path_) {
      const auto from = std::max(first, found.first_frame);
      const auto to = std::min(end, found.first_frame + found.frames);
      if (from >= to) continue;
      sum +=
          found.log_likelihood * static_cast<double>(to - from) / static_cast<double>(found.frames);
    }
    return sum;
  }

 private:
  std::span<const FoundPhone> path_;
};

/// Keeps the phones' order, rest at least empty and every other phone at least 30 ms long.
void make_room(std::vector<TimedPhone>& phones, Duration end) {
  std::vector<Duration> starts;
  for (const auto& timed : phones) starts.push_back(std::clamp(timed.start, Duration{}, end));
  const auto least = [&](std::size_t i) {
    return phones[i].phone == Phone::Rest ? Duration{} : kShortestPhone;
  };
  starts.front() = Duration{};
  starts.push_back(end);
  for (std::size_t i = 0; i < phones.size(); ++i) {
    starts[i + 1] = std::max(starts[i + 1], starts[i] + least(i));
  }
  starts.back() = end;
  for (std::size_t i = phones.size(); i-- > 0;) {
    starts[i] = std::min(starts[i], starts[i + 1] - least(i));
  }
  for (std::size_t i = 0; i < phones.size(); ++i) {
    phones[i].start = starts[i];
    phones[i].duration = starts[i + 1] - starts[i];
  }
}

}  // namespace

struct Aligner::Decoder {
  PhoneSearch search;
};

Aligner::Aligner() : decoder_{std::make_unique<Decoder>()} {}

Aligner::~Aligner() = default;
Aligner::Aligner(Aligner&&) noexcept = default;
Aligner& Aligner::operator=(Aligner&&) noexcept = default;

Alignment Aligner::align(const Clip& sound, std::span<const Phone> phones) {
  const SpokenWord word{.spelling = {}, .pronunciations = {{phones.begin(), phones.end()}}};
  return align(sound, std::span{&word, 1});
}

Alignment Aligner::align(const Clip& sound, std::span<const SpokenWord> words) {
  refuse_impossible_words(words);
  refuse_impossible_length(sound, words);
  const auto heard = search_sound(sound);
  const auto path = decoder_->search.best_path(grammar_of(words), heard.samples);
  const auto read = words_on(path, words);
  if (!read) {
    throw Error{
        fmt::format("aligning {}: the recording of {:.0f} ms cannot be heard as that; "
                    "check that it is what is said, and nothing else",
                    named(words),
                    milliseconds(sound.duration()))};
  }
  const auto free = decoder_->search.free_path(heard.samples);
  const FreeScore free_score{free};

  Alignment made;
  auto& phones = made.utterance.phones;
  for (const auto& found : path) {
    const auto start = static_cast<std::int64_t>(found.first_frame) * PhoneSearch::kFrame;
    phones.push_back({found.token.phone, start - heard.padding + kShift, {}});
  }
  double all = 0.0;
  std::size_t all_frames = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto& [first, chosen] = read->at(i);
    const auto& said = words[i].pronunciations[chosen];
    double score = 0.0;
    std::size_t frames = 0;
    for (std::size_t k = 0; k < said.size(); ++k) {
      phones[first + k].phone = said[k];
      score += path[first + k].log_likelihood;
      frames += path[first + k].frames;
    }
    const auto begins = path[first].first_frame;
    score -= free_score.between(begins, begins + frames);
    made.words.push_back({words[i].spelling, first, said.size()});
    made.fit_of_word.push_back(score / static_cast<double>(frames));
    all += score;
    all_frames += frames;
  }
  made.fit = all / static_cast<double>(all_frames);
  make_room(phones, sound.duration());
  return made;
}

}  // namespace bimodal
