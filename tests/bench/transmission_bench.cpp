#include <string>
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>

#include "analysis/statistics/matrix_sampler.hpp"
#include "analysis/statistics/transmission_interval.hpp"

namespace bimodal::analysis {
namespace {

constexpr std::size_t kLabels = 18;
constexpr std::int64_t kResponses = 120;  ///< a row, so 2,160 in all
constexpr int kDraws = 10'000;

MatrixSampler sampler() {
  std::vector<double> proportions;
  for (std::size_t i = 0; i < kLabels; ++i) {
    for (std::size_t j = 0; j < kLabels; ++j) {
      proportions.push_back(i == j ? 0.5 : 0.5 / (kLabels - 1));
    }
  }
  return {proportions, std::vector<std::int64_t>(kLabels, kResponses), kLabels};
}

/// 10,000 matrices of 18 x 18 with 2,160 responses, drawn from proportions, and what each
/// transmits; state.range(0) threads.
void bootstraps_of_transmission(benchmark::State& state) {
  const auto from = sampler();
  const auto threads = state.range(0);
  const auto work = [&](std::int64_t thread) {
    Random random{derive_seed(1, "bench", {static_cast<std::uint64_t>(thread)})};
    TransmissionOfCounts transmission{
        kLabels, kLabels, kResponses * static_cast<std::int64_t>(kLabels)};
    CellCounts counts;
    for (auto draw = thread; draw < kDraws; draw += threads) {
      from.draw(random, counts);
      benchmark::DoNotOptimize(transmission.observed(counts));
    }
  };
  for (auto unused : state) {
    std::vector<std::jthread> others;
    for (std::int64_t thread = 1; thread < threads; ++thread) others.emplace_back(work, thread);
    work(0);
  }
}

/// The interval of one such matrix, and the measuring of its coverage.
void interval_of_transmission(benchmark::State& state) {
  Random random{2};
  CellCounts counts;
  sampler().draw(random, counts);
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < kLabels; ++i) labels.push_back(std::to_string(i));
  const ConfusionMatrix matrix{labels, labels, {counts.begin(), counts.end()}};
  for (auto unused : state) benchmark::DoNotOptimize(transmission_interval(matrix, 1));
}

BENCHMARK(bootstraps_of_transmission)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(interval_of_transmission)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace bimodal::analysis
