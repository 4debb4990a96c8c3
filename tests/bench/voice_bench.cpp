// Speaking one word, with each of Festival's voices that is installed.
#include <algorithm>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "synth/voice/voice.hpp"

namespace bimodal::synth {
namespace {

using enum Phone;

void speaking_a_word(benchmark::State& state, const std::string& name) {
  const auto names = Voice::installed();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    state.SkipWithError("the voice is not installed");
    return;
  }
  const Voice voice{name};
  const std::vector<Pronunciation> words{
      {S, T, UW}, {B, AE, G}, {M, AE, P}, {TH, IH, N}, {S, P, R, AW, T}, {W, IH, SH}};
  std::size_t next = 0;
  for (auto unused : state) {
    benchmark::DoNotOptimize(voice.speak("word", words[next++ % words.size()]));
  }
}

BENCHMARK_CAPTURE(speaking_a_word, kal, "kal")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(speaking_a_word, slt, "slt")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace bimodal::synth
