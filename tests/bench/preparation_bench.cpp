// How long the parts of one trial take that must be ready before the participant is.

#include <benchmark/benchmark.h>

#include "runner/preparation/film_studio.hpp"
#include "runner/preparation/trial_preparer.hpp"

namespace bimodal::runner {
namespace {

protocols::Protocol protocol() {
  protocols::Protocol made;
  made.conditions = {{.name = "bimodal",
                      .auditory_talker = "festival:kal",
                      .visual_talker = "face",
                      .snr = Decibels{-8.0}}};
  return made;
}

const std::map<std::string, Corpus>& no_corpora() {
  static const std::map<std::string, Corpus> none;
  return none;
}

protocols::PlannedTrial stew() {
  return {.word = {.spelling = "stew", .phones = {Phone::S, Phone::T, Phone::UW}}, .noise_seed = 3};
}

/// Mixing in noise and hashing: what a rehearsed trial costs.
void prepare_the_sound_of_a_trial(benchmark::State& state) {
  const auto made = protocol();
  Repertoire repertoire{made.sound.rate, no_corpora()};
  TrialPreparer preparer{made, repertoire, nullptr, Hertz{60}};
  const auto trial = stew();
  for (auto _ : state) benchmark::DoNotOptimize(preparer.prepare(trial));
}

BENCHMARK(prepare_the_sound_of_a_trial)->Unit(benchmark::kMillisecond);

/// The same and every picture, 640 x 720 at 60 Hz: must be shorter than a trial lasts (about 5 s).
void prepare_a_bimodal_trial_with_its_pictures(benchmark::State& state) {
  const auto made = protocol();
  Repertoire repertoire{made.sound.rate, no_corpora()};
  FilmStudio studio{made.window, no_corpora()};
  TrialPreparer preparer{made, repertoire, &studio, Hertz{60}};
  const auto trial = stew();
  std::size_t pictures = 0;
  for (auto _ : state) pictures = preparer.prepare(trial).film->pictures.size();
  state.counters["pictures"] = static_cast<double>(pictures);
}

BENCHMARK(prepare_a_bimodal_trial_with_its_pictures)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace bimodal::runner
