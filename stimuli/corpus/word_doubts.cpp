#include "stimuli/corpus/word_doubts.hpp"

#include <fmt/format.h>

#include "stimuli/base/milliseconds.hpp"

namespace bimodal {

namespace {

using namespace std::chrono_literals;

constexpr Duration kShortestVowel = 30ms;
constexpr Duration kLongestPhone = 700ms;
constexpr Duration kLongestWord = 1500ms;

}  // namespace

std::vector<std::string> duration_doubts(std::span<const TimedPhone> phones, bool running) {
  std::vector<std::string> doubts;
  for (const auto& timed : phones) {
    const bool is_short = !running && is_vowel(timed.phone) && timed.duration <= kShortestVowel;
    const bool is_long = timed.phone != Phone::Rest && timed.duration > kLongestPhone;
    if (!is_short && !is_long) continue;
    doubts.push_back(fmt::format("its {} lasts {} {:.0f} ms",
                                 symbol(timed.phone),
                                 is_short ? "only" : "as long as",
                                 milliseconds(timed.duration)));
  }
  if (phones.empty()) return doubts;
  if (const auto length = phones.back().end() - phones.front().start; length > kLongestWord) {
    doubts.push_back(fmt::format("the word lasts {:.1f} s", milliseconds(length) / 1000.0));
  }
  return doubts;
}

std::vector<SaidWord> said_words(const Alignment& alignment, Duration start, bool running) {
  std::vector<SaidWord> said;
  for (std::size_t i = 0; i < alignment.words.size(); ++i) {
    const auto& word = alignment.words[i];
    SaidWord made{.word = word.spelling};
    for (std::size_t k = 0; k < word.phones; ++k) {
      made.phones.push_back(alignment.utterance.phones.at(word.first_phone + k));
      made.phones.back().start += start;
    }
    made.doubts = duration_doubts(made.phones, running);
    const double fit = alignment.fit_of_word.at(i);
    made.fit = fit;
    if (fit < kDoubtfulFit) {
      made.doubts.push_back(
          fmt::format("its sound hardly fits the phones (fit {:.1f}, good words are above {:.1f})",
                      fit,
                      kDoubtfulFit));
    }
    said.push_back(std::move(made));
  }
  return said;
}

}  // namespace bimodal
