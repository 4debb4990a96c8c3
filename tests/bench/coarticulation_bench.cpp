// Coarticulation of a word of one second at 60 Hz (promised: under 50 us), of long texts (linear in
// their length), and the whole way from text to tracks (promised: under 100 us a word).
#include <vector>

#include <benchmark/benchmark.h>

#include "stimuli/base/asset.hpp"
#include "stimuli/words/dictionary.hpp"
#include "stimuli/words/text_phones.hpp"
#include "synth/speech/articulation.hpp"
#include "synth/speech/durations.hpp"
#include "synth/voice/voice.hpp"

namespace bimodal::synth {
namespace {

using namespace std::chrono_literals;
using enum Phone;

/// "sprout", with the pauses that a voice leaves around it: eight segments of the face, 1 s.
Utterance word_of_one_second() {
  struct Timed {
    Phone phone;
    Duration duration;
  };

  Utterance utterance;
  for (const auto& [phone, duration] : {Timed{Rest, 200ms},
                                        {S, 120ms},
                                        {P, 80ms},
                                        {R, 60ms},
                                        {AW, 240ms},
                                        {T, 80ms},
                                        {Rest, 220ms}}) {
    utterance.phones.push_back({.phone = phone, .start = utterance.end(), .duration = duration});
  }
  return utterance;
}

void coarticulation_of_one_second_at_60_hz(benchmark::State& state) {
  const SegmentTable table{asset("synth/assets/segments/english.json")};
  const auto utterance = word_of_one_second();
  for (auto unused : state) {
    const Articulation articulation{utterance, table};
    benchmark::DoNotOptimize(articulation.sample(Hertz{60}));
  }
}

/// A text of that many segments: every instant of a second, whatever the length.
void coarticulation_of_a_long_text(benchmark::State& state) {
  const SegmentTable table{asset("synth/assets/segments/english.json")};
  std::vector<Segment> said;
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    said.emplace_back(all_phones()[static_cast<std::size_t>(7 * i) % kPhoneCount]);
  }
  const auto segments = timed(said);
  for (auto unused : state) {
    const Articulation articulation{segments, table};
    benchmark::DoNotOptimize(articulation.sample(Hertz{60}));
  }
  state.SetComplexityN(state.range(0));
}

/// "stew" by the dictionary, timed by intrinsic durations, every control at 60 Hz.
void text_to_tracks_by_dictionary(benchmark::State& state) {
  const SegmentTable table{asset("synth/assets/segments/english.json")};
  const Dictionary dictionary{Dictionary::installed()};
  const auto rules = LetterToSound::shipped();
  for (auto unused : state) {
    const auto words = phones_by_dictionary("stew", dictionary, rules);
    const std::vector<Segment> said(words.front().phones.begin(), words.front().phones.end());
    const Articulation articulation{timed(said), table};
    benchmark::DoNotOptimize(articulation.sample(Hertz{60}));
  }
}

/// The same spoken by Festival, whose interpreter runs already; its time is that of the sound.
void text_to_tracks_by_festival(benchmark::State& state) {
  const SegmentTable table{asset("synth/assets/segments/english.json")};
  const Voice voice{"kal"};
  static_cast<void>(voice.speak("stew"));
  for (auto unused : state) {
    const auto item = voice.speak("stew");
    const Articulation articulation{item.utterance, table};
    benchmark::DoNotOptimize(articulation.sample(Hertz{60}));
  }
}

void segment_table_from_file(benchmark::State& state) {
  const auto file = asset("synth/assets/segments/english.json");
  for (auto unused : state) benchmark::DoNotOptimize(SegmentTable{file});
}

BENCHMARK(coarticulation_of_one_second_at_60_hz)->Unit(benchmark::kMicrosecond);
BENCHMARK(coarticulation_of_a_long_text)
    ->Arg(100)
    ->Arg(1'000)
    ->Arg(10'000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);
BENCHMARK(text_to_tracks_by_dictionary)->Unit(benchmark::kMicrosecond);
BENCHMARK(text_to_tracks_by_festival)->Unit(benchmark::kMillisecond);
BENCHMARK(segment_table_from_file)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bimodal::synth
