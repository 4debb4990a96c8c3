// From a table of trials as CSV to everything that the report writes as CSV: reading, scoring,
// proportions, confusions, information.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "analysis/data/trials_file.hpp"
#include "analysis/report/information_table.hpp"
#include "analysis/report/tables.hpp"
#include "analysis/scoring/lexicon.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/random.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::analysis {
namespace {

constexpr std::size_t kConditions = 4;

std::vector<std::string> word_list() {
  std::vector<Diagnostic> diagnostics;
  std::vector<std::string> spellings;
  for (const auto& word :
       read_word_list(asset("stimuli/assets/words/monosyllables-414.json"), diagnostics).words) {
    spellings.push_back(word.spelling);
  }
  return spellings;
}

/// Half of the answers right, some blank, some no word, the others another word of the list.
std::string answer(const std::vector<std::string>& words, std::size_t word, Random& random) {
  const double kind = random.uniform();
  if (kind < 0.5) return words[word];
  if (kind < 0.53) return "";
  if (kind < 0.58) return words[word] + "zq";
  return words[random.below(words.size())];
}

/// Each participant meets every word in every condition.
std::string table_of_trials(std::size_t participants) {
  const auto words = word_list();
  Random random{1};
  std::string table = "participant,trial,condition,stimulus,response,response_ms\n";
  for (std::size_t participant = 0; participant < participants; ++participant) {
    for (std::size_t trial = 0; trial < words.size() * kConditions; ++trial) {
      const auto word = trial / kConditions;
      table += fmt::format("P{:04},{},{},{},{},{}\n",
                           participant,
                           trial,
                           "ABCD"[trial % kConditions],
                           words[word],
                           answer(words, word, random),
                           600 + random.below(3'000));
    }
  }
  return table;
}

/// The most memory that this program ever had, from now on. Does nothing where the system cannot.
void forget_peak_memory() {
  std::ofstream{"/proc/self/clear_refs"} << 5;
}

double peak_memory_mb() {
  std::ifstream status{"/proc/self/status"};
  std::string word;
  while (status >> word) {
    double kilobytes = 0.0;
    if (word == "VmHWM:" && status >> kilobytes) return kilobytes / 1e3;
  }
  return 0.0;
}

/// Reads, scores and counts; as many resamples as the report takes.
Results results_of(const std::filesystem::path& table, const Dictionary& dictionary) {
  std::vector<TrialsOfFile> files;
  files.push_back(read_trials(table));
  auto dataset = gather(std::move(files));
  pronounce_stimuli(dataset.trials, dictionary);
  return analyse(std::move(dataset), dictionary, {.file = "words.dict", .sha256 = ""});
}

void all_tables(benchmark::State& state) {
  const WrittenFiles folder;
  const auto table =
      folder.write("trials.csv", table_of_trials(static_cast<std::size_t>(state.range(0))));
  const Dictionary dictionary{Dictionary::installed()};
  std::size_t trials = 0;
  std::size_t bytes = 0;
  forget_peak_memory();
  for (auto unused : state) {
    const auto results = results_of(table, dictionary);
    trials = results.dataset.trials.size();
    for (const auto& confusions : results.confusions) {
      benchmark::DoNotOptimize(tabulate_information(confusions.condition, confusions.matrix));
    }
    for (const auto& file :
         report_tables(results, {.program = "", .made_utc = "", .selection = ""})) {
      bytes = std::max(bytes, file.content.size());
    }
  }
  state.counters["trials"] = static_cast<double>(trials);
  state.counters["peak_MB"] = peak_memory_mb();
  state.counters["largest_table_MB"] = static_cast<double>(bytes) / 1e6;
}

/// 33,120 trials: 20 participants.
BENCHMARK(all_tables)->Arg(20)->Unit(benchmark::kMillisecond)->UseRealTime();

/// 250,000 and 1,000,000 trials.
BENCHMARK(all_tables)
    ->Arg(151)
    ->Arg(604)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace bimodal::analysis
