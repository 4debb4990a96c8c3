// How long the parts of one trial take that must be ready before the participant is.

#include <filesystem>
#include <string>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "runner/preparation/film_cache.hpp"
#include "runner/preparation/film_key.hpp"
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
  FilmStudio studio{made.window, no_corpora(), synth::Quality::Fast};
  TrialPreparer preparer{made, repertoire, &studio, Hertz{60}};
  const auto trial = stew();
  std::size_t pictures = 0;
  for (auto _ : state) pictures = preparer.prepare(trial).film->pictures.size();
  state.counters["pictures"] = static_cast<double>(pictures);
}

BENCHMARK(prepare_a_bimodal_trial_with_its_pictures)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A cache of this program's own; it goes when the benchmark ends.
class EmptyCache {
 public:
  EmptyCache() { std::filesystem::remove_all(folder_); }

  EmptyCache(const EmptyCache&) = delete;
  EmptyCache& operator=(const EmptyCache&) = delete;
  EmptyCache(EmptyCache&&) = delete;
  EmptyCache& operator=(EmptyCache&&) = delete;

  ~EmptyCache() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  [[nodiscard]] FilmCache cache() const { return FilmCache{folder_}; }

  [[nodiscard]] double bytes() const {
    double sum = 0;
    for (const auto& file : std::filesystem::directory_iterator{folder_}) {
      sum += static_cast<double>(file.file_size());
    }
    return sum;
  }

 private:
  std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
                                  ("bimodal_bench_films_" + std::to_string(::getpid()));
};

/// The same trial when an earlier session has drawn it.
void prepare_a_bimodal_trial_from_the_cache(benchmark::State& state) {
  const auto made = protocol();
  const EmptyCache kept;
  Repertoire repertoire{made.sound.rate, no_corpora()};
  FilmStudio studio{made.window, no_corpora(), synth::Quality::Fast, kept.cache()};
  TrialPreparer preparer{made, repertoire, &studio, Hertz{60}};
  const auto trial = stew();
  std::size_t pictures = preparer.prepare(trial).film->pictures.size();
  for (auto _ : state) pictures = preparer.prepare(trial).film->pictures.size();
  state.counters["pictures"] = static_cast<double>(pictures);
  state.counters["KB a picture"] = kept.bytes() / 1e3 / static_cast<double>(pictures);
}

BENCHMARK(prepare_a_bimodal_trial_from_the_cache)->Unit(benchmark::kMillisecond)->UseRealTime();

/// What keeping its pictures costs.
void keep_the_film_of_a_trial(benchmark::State& state) {
  const auto made = protocol();
  const EmptyCache kept;
  Repertoire repertoire{made.sound.rate, no_corpora()};
  FilmStudio studio{made.window, no_corpora(), synth::Quality::Fast};
  TrialPreparer preparer{made, repertoire, &studio, Hertz{60}};
  const auto film = preparer.prepare(stew()).film;
  const auto cache = kept.cache();
  for (auto _ : state) cache.keep("stew", *film, [] {});
}

BENCHMARK(keep_the_film_of_a_trial)->Unit(benchmark::kMillisecond)->UseRealTime();

/// What the first film of a session costs before it can be looked for.
void identify_the_drawing(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(drawing_identity());
}

BENCHMARK(identify_the_drawing)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace bimodal::runner
