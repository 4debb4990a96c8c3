// Finding phones: one word, and the 414 words by one aligner and by two in two threads.
#include <algorithm>
#include <chrono>
#include <span>
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>

#include "stimuli/alignment/aligner.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/words/word_list.hpp"
#include "synth/voice/voice.hpp"

namespace bimodal {
namespace {

struct SpokenList {
  std::vector<Word> words;
  std::vector<Clip> sounds;
  double seconds = 0.0;
};

const SpokenList& spoken_list() {
  static const SpokenList list = [] {
    SpokenList made;
    std::vector<Diagnostic> diagnostics;
    made.words =
        read_word_list(asset("stimuli/assets/words/monosyllables-414.json"), diagnostics).words;
    const synth::Voice voice{"kal"};
    for (const auto& word : made.words) {
      made.sounds.push_back(voice.speak(word.spelling, word.phones).sound);
      made.seconds += std::chrono::duration<double>{made.sounds.back().duration()}.count();
    }
    return made;
  }();
  return list;
}

void report_real_time_factor(benchmark::State& state, double sound_seconds) {
  state.counters["s_sound_per_s"] =
      benchmark::Counter{sound_seconds, benchmark::Counter::kIsIterationInvariantRate};
}

void aligning_a_word(benchmark::State& state) {
  const auto& list = spoken_list();
  Aligner aligner;
  for (auto unused : state) {
    benchmark::DoNotOptimize(aligner.align(list.sounds.front(), list.words.front().phones));
  }
  report_real_time_factor(state,
                          std::chrono::duration<double>{list.sounds.front().duration()}.count());
}

void aligning_414_words(benchmark::State& state) {
  const auto& list = spoken_list();
  const auto threads = static_cast<std::size_t>(state.range(0));
  const auto align_every = [&](std::size_t first) {
    Aligner aligner;
    for (std::size_t i = first; i < list.words.size(); i += threads) {
      benchmark::DoNotOptimize(aligner.align(list.sounds[i], list.words[i].phones));
    }
  };
  for (auto unused : state) {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < threads; ++i) others.emplace_back(align_every, i);
    align_every(0);
  }
  report_real_time_factor(state, list.seconds);
}

void aligning_ten_minutes(benchmark::State& state) {
  const auto& list = spoken_list();
  Clip all{list.sounds.front().rate, {}};
  std::vector<SpokenWord> words;
  for (std::size_t i = 0; all.duration() < std::chrono::minutes{9}; ++i) {
    const auto& sound = list.sounds[i % list.sounds.size()];
    const auto& word = list.words[i % list.words.size()];
    all.samples.insert(all.samples.end(), sound.samples.begin(), sound.samples.end());
    words.push_back({word.spelling, {word.phones}});
  }
  Aligner aligner;
  for (auto unused : state) benchmark::DoNotOptimize(aligner.align(all, words));
  report_real_time_factor(state, std::chrono::duration<double>{all.duration()}.count());
}

void starting_an_aligner(benchmark::State& state) {
  for (auto unused : state) {
    Aligner aligner;
    benchmark::DoNotOptimize(aligner);
  }
}

BENCHMARK(aligning_a_word)->Unit(benchmark::kMillisecond);
BENCHMARK(aligning_414_words)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(aligning_ten_minutes)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(starting_an_aligner)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bimodal
