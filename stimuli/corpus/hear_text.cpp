#include "stimuli/corpus/hear_text.hpp"

#include <fmt/format.h>

#include "stimuli/audio/band.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/corpus/side_by_side.hpp"
#include "stimuli/corpus/word_doubts.hpp"

namespace bimodal {

namespace {

double seconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

SaidWord align_placed(Aligner& aligner, const Clip& sound, const PlacedWord& placed) {
  const SpeechInterval place{placed.start, std::min(placed.end, sound.duration())};
  const auto samples = cut(sound, place);
  const Clip stretch{sound.rate, {samples.begin(), samples.end()}};
  auto said = std::move(
      said_words(aligner.align(stretch, std::span{&placed.word, 1}), place.start, true).front());
  // The hand's edges are the word's.
  auto& first = said.phones.front();
  first.duration = first.end() - place.start;
  first.start = place.start;
  said.phones.back().duration = place.end - said.phones.back().start;
  said.doubts = duration_doubts(said.phones, true);
  said.fit.reset();
  return said;
}

}  // namespace

SaidWords hear_text(const Clip& sound, std::span<const SpokenWord> text) {
  Aligner aligner;
  const bool running = text.size() > 1;
  return {.words = said_words(aligner.align(sound, text), Duration{}, running), .running = running};
}

SaidWords hear_placed(const Clip& sound, std::span<const PlacedWord> words) {
  SaidWords said;
  said.words.resize(words.size());
  side_by_side(words.size(), [&] {
    return [&, aligner = Aligner{}](std::size_t index) mutable {
      const auto& placed = words[index];
      try {
        said.words[index] = align_placed(aligner, sound, placed);
      } catch (const Error&) {
        std::throw_with_nested(
            Error{fmt::format("finding the phones of \"{}\" at {:.3f} to {:.3f} s",
                              placed.word.spelling,
                              seconds(placed.start),
                              seconds(placed.end))});
      }
    };
  });
  return said;
}

}  // namespace bimodal
