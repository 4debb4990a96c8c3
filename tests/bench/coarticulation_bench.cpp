// Coarticulation of a word of one second at 60 Hz: the project promises under 100 us.
#include <benchmark/benchmark.h>

#include "stimuli/base/asset.hpp"
#include "synth/speech/articulation.hpp"

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

void segment_table_from_file(benchmark::State& state) {
  const auto file = asset("synth/assets/segments/english.json");
  for (auto unused : state) benchmark::DoNotOptimize(SegmentTable{file});
}

BENCHMARK(coarticulation_of_one_second_at_60_hz)->Unit(benchmark::kMicrosecond);
BENCHMARK(segment_table_from_file)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bimodal::synth
