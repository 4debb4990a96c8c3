#include <benchmark/benchmark.h>

#include "analysis/statistics/condition_permutation.hpp"
#include "stimuli/base/random.hpp"

namespace bimodal::analysis {
namespace {

/// 49,680 pairs of phonemes in two conditions: 20 participants x 414 words of three phones, each
/// answered rightly in half of the cases. 10,000 permutations of words' conditions.
void permute_phonemes(benchmark::State& state) {
  constexpr std::uint32_t kLabels = 24;
  Random random{1};
  std::vector<ComparedTrial> trials;
  for (std::uint32_t participant = 0; participant < 20; ++participant) {
    for (std::uint32_t item = 0; item < 414; ++item) {
      for (const bool other : {false, true}) {
        auto& trial = trials.emplace_back(
            ComparedTrial{.participant = participant, .item = item, .other = other});
        for (std::uint32_t phone = 0; phone < 3; ++phone) {
          const auto stimulus = (item + 7 * phone) % kLabels;
          const auto wrong = static_cast<std::uint32_t>(random.below(kLabels));
          trial.cells.push_back(stimulus * kLabels + (random.below(2) == 0 ? stimulus : wrong));
        }
      }
    }
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(permute_conditions(trials, kLabels, kLabels, 10'000, 1));
  }
}

BENCHMARK(permute_phonemes)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace bimodal::analysis
