#include "stimuli/alignment/aligner.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/alignment/acoustic_model.hpp"
#include "stimuli/alignment/cepstra.hpp"
#include "stimuli/alignment/edge_correction.hpp"
#include "stimuli/alignment/search_sound.hpp"
#include "stimuli/alignment/word_graph.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/milliseconds.hpp"

namespace bimodal {

namespace {

constexpr Duration kLongest = std::chrono::minutes{10};
constexpr Duration kShortestPhone = CepstraMaker::kFrame * kStates;

/// A frame hears 25.6 ms from its start; the edge between two lies between their centres.
constexpr Duration kShift = (CepstraMaker::kWindow - CepstraMaker::kFrame) / 2;

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

std::size_t fewest_phones(std::span<const SpokenWord> words) {
  std::size_t phones = 0;
  for (const auto& word : words) {
    phones += std::ranges::min_element(word.pronunciations, {}, &Pronunciation::size)->size();
  }
  return phones;
}

std::size_t phones_in(const Alignment& alignment) {
  std::size_t phones = 0;
  for (const auto& word : alignment.words) phones += word.phones;
  return phones;
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
  if (!(sound.rate.count() > 0.0)) {
    throw Error{fmt::format("aligning {}: the recording has {} samples per second; give its rate",
                            named(words),
                            sound.rate.count())};
  }
  const auto length = sound.duration();
  if (length > kLongest) {
    throw Error{
        fmt::format("aligning {}: the recording lasts {:.1f} minutes, more than {}; cut it "
                    "into parts at pauses",
                    named(words),
                    milliseconds(length) / 60'000.0,
                    kLongest / std::chrono::minutes{1})};
  }
}

void refuse_too_many_phones(const Clip& sound,
                            std::size_t phones,
                            std::span<const SpokenWord> words) {
  const auto length = sound.duration();
  const auto needed = kShortestPhone * phones;
  if (length >= needed) return;
  throw Error{
      fmt::format("aligning {}: the recording lasts {:.0f} ms, but {} phones need at least "
                  "{:.0f} ms; give the whole recording, or fewer phones",
                  named(words),
                  milliseconds(length),
                  phones,
                  milliseconds(needed))};
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

/// The phones and words of a path, without times.
Alignment words_on(std::span<const PathStep> path,
                   const WordGraph& graph,
                   std::span<const SpokenWord> words) {
  Alignment made;
  for (const auto& word : words) made.words.push_back({.spelling = word.spelling});
  for (std::size_t i = 0; i < path.size(); ++i) {
    made.utterance.phones.push_back({.phone = graph.nodes[path[i].node].phone});
    const auto word = graph.word[path[i].node];
    if (!word) continue;
    if (made.words[*word].phones == 0) made.words[*word].first_phone = i;
    ++made.words[*word].phones;
  }
  return made;
}

/// Gives the alignment its fits. The phones are scored without their contexts, as the free sequence
/// is, so that no fit is above 0. `scores` are those of the words' phones, in all frames.
void judge(Alignment& alignment,
           std::span<const PathStep> path,
           UnitScores scores,
           std::span<const Cepstra> cepstra,
           const AcousticModel& model) {
  auto others = context_free_units(model, path.front().frames, path.back().first_frame);
  for (std::size_t unit = 0; unit < others.size(); ++unit) {
    if (scores.has(unit)) others[unit].end_frame = others[unit].first_frame;
  }
  scores.complete_from(model.score(cepstra, others));
  std::vector<PhoneNode> any_phones;
  for (const Phone phone : all_phones()) {
    if (modelled(phone) == phone) any_phones.push_back(context_free_node(phone));
  }
  double lacking = 0.0;
  std::size_t frames = 0;
  for (const auto& word : alignment.words) {
    const auto& first = path[word.first_phone];
    const auto& last = path[word.first_phone + word.phones - 1];
    const auto length = last.first_frame + last.frames - first.first_frame;
    double lacks = -free_likelihood(any_phones, first.first_frame, length, scores, model);
    for (std::size_t i = word.first_phone; i < word.first_phone + word.phones; ++i) {
      const auto node = context_free_node(alignment.utterance.phones[i].phone);
      lacks += phone_likelihood(node, path[i].first_frame, path[i].frames, scores, model);
    }
    alignment.fit_of_word.push_back(lacks / static_cast<double>(length));
    lacking += lacks;
    frames += length;
  }
  alignment.fit = lacking / static_cast<double>(frames);
}

/// Rest between words that has no time left after all.
void remove_empty_pauses(Alignment& alignment) {
  auto& phones = alignment.utterance.phones;
  for (std::size_t i = phones.size() - 1; i-- > 1;) {
    if (phones[i].phone != Phone::Rest || phones[i].duration > Duration{}) continue;
    phones.erase(phones.begin() + static_cast<std::ptrdiff_t>(i));
    for (auto& word : alignment.words) word.first_phone -= word.first_phone > i ? 1 : 0;
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
  refuse_too_many_phones(sound, fewest_phones(words), words);
  const auto& model = decoder_->model;
  const auto heard = search_sound(sound);
  const auto cepstra = decoder_->cepstra.make(heard.samples);
  const auto graph = graph_of(words);
  auto scores = model.score(cepstra, units_of(graph, model));
  const auto coarse = best_path(graph.nodes, scores, model);
  if (!coarse) throw std::logic_error{"a path through a long enough recording always exists"};
  const auto chain = chain_of(*coarse, graph, model);
  const auto path = best_path(chain.graph.nodes, model.score(cepstra, chain.units), model);
  if (!path) throw std::logic_error{"the coarse path has become impossible"};

  Alignment made = words_on(*path, chain.graph, words);
  for (std::size_t i = 0; i < path->size(); ++i) {
    const auto start = static_cast<std::int64_t>(path->at(i).first_frame) * CepstraMaker::kFrame;
    made.utterance.phones[i].start = start - heard.padding + kShift;
  }
  refuse_too_many_phones(sound, phones_in(made), words);
  correct_edges(made.utterance.phones, heard);
  make_room(made.utterance.phones, sound.duration());
  judge(made, *path, std::move(scores), cepstra, model);
  remove_empty_pauses(made);
  return made;
}

}  // namespace bimodal
