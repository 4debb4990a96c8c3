#include "stimuli/alignment/aligner.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/alignment/acoustic_model.hpp"
#include "stimuli/alignment/cepstra.hpp"
#include "stimuli/alignment/search_sound.hpp"
#include "stimuli/alignment/word_graph.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

constexpr Duration kLongest = std::chrono::minutes{10};
constexpr Duration kShortestPhone = CepstraMaker::kFrame * kStates;

/// A frame hears 25.6 ms from its start; the edge between two lies between their centres.
constexpr Duration kShift = (CepstraMaker::kWindow - CepstraMaker::kFrame) / 2;

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
  AcousticModel model{AcousticModel::installed()};
  CepstraMaker cepstra{AcousticModel::installed() / "feat.params"};
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
  const auto scores = decoder_->model.score(decoder_->cepstra.make(heard.samples));
  const auto graph = graph_of(words);
  const auto path = best_path(graph.nodes, scores, decoder_->model);
  if (!path) throw std::logic_error{"an alignment of a long enough recording always exists"};

  Alignment made;
  for (const auto& word : words) made.words.push_back({.spelling = word.spelling});
  std::vector<double> likelihoods(words.size());
  std::vector<std::size_t> begins(words.size());
  std::vector<std::size_t> frames(words.size());
  for (const auto& step : *path) {
    const auto phone = graph.nodes[step.node].phone;
    const auto start = static_cast<std::int64_t>(step.first_frame) * CepstraMaker::kFrame;
    if (const auto word = graph.word[step.node]) {
      if (made.words[*word].phones++ == 0) {
        made.words[*word].first_phone = made.utterance.phones.size();
        begins[*word] = step.first_frame;
      }
      frames[*word] += step.frames;
      likelihoods[*word] +=
          phone_likelihood(phone, step.first_frame, step.frames, scores, decoder_->model);
    }
    made.utterance.phones.push_back({phone, start - heard.padding + kShift, {}});
  }
  double all = 0.0;
  std::size_t all_frames = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const double lacking =
        likelihoods[i] - free_likelihood(begins[i], frames[i], scores, decoder_->model);
    made.fit_of_word.push_back(lacking / static_cast<double>(frames[i]));
    all += lacking;
    all_frames += frames[i];
  }
  made.fit = all / static_cast<double>(all_frames);
  make_room(made.utterance.phones, sound.duration());
  return made;
}

}  // namespace bimodal
