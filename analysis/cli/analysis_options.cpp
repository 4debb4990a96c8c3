#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <system_error>

#include <fmt/format.h>

#include "analysis/cli/scoring_options.hpp"
#include "analysis/cli/verb.hpp"
#include "analysis/data/stored_data.hpp"
#include "analysis/data/trials_file.hpp"
#include "analysis/scoring/lexicon.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/lower_case.hpp"
#include "stimuli/base/whole_number.hpp"

namespace bimodal::analysis {

namespace {

/// Says what is being done, on one line that the next step overwrites.
class ProgressLine {
 public:
  explicit ProgressLine(Console console) : console_{console} {}

  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ProgressLine(ProgressLine&&) = delete;
  ProgressLine& operator=(ProgressLine&&) = delete;

  ~ProgressLine() {
    if (console_.show_progress) console_.err << "\r\033[K" << std::flush;
  }

  void show(std::string_view step) {
    if (console_.show_progress) console_.err << "\r\033[K" << step << " ..." << std::flush;
  }

 private:
  Console console_;
};

/// "visual=0.1".
std::string criterion_fault(const std::string& text, Criterion& criterion) {
  const auto at = text.rfind('=');
  const auto proportion = at == std::string::npos ? std::string{} : text.substr(at + 1);
  const auto* const end = proportion.data() + proportion.size();
  const auto [reached, fault] = std::from_chars(proportion.data(), end, criterion.least);
  const bool good = fault == std::errc{} && reached == end && criterion.least >= 0.0 &&
                    criterion.least <= 1.0 && at > 0;
  criterion.condition = text.substr(0, at);
  return good ? std::string{}
              : fmt::format(
                    "\"{}\" is no criterion; write a condition and a proportion, like "
                    "auditory=0.2",
                    text);
}

void add_time_limit(CLI::App& verb,
                    const std::string& name,
                    std::optional<Duration>& limit,
                    const std::string& meaning) {
  verb.add_option_function<double>(
          name, [&limit](double ms) { limit = Duration{std::llround(ms * 1e6)}; }, meaning)
      ->check(CLI::Range(-1e7, 1e7))
      ->type_name("MS");
}

void add_exclusion_options(CLI::App& verb, AnalysisRequest& request) {
  add_time_limit(verb,
                 "--fastest",
                 request.selection.fastest,
                 "Leave out trials answered in less than so many ms");
  add_time_limit(verb,
                 "--slowest",
                 request.selection.slowest,
                 "Leave out trials answered after more than so many ms");
  verb.add_option_function<std::vector<std::string>>(
          "--at-least",
          [&request](const std::vector<std::string>& texts) {
            for (const auto& text : texts) {
              Criterion criterion;
              if (const auto fault = criterion_fault(text, criterion); !fault.empty()) {
                throw CLI::ValidationError("--at-least", fault);
              }
              request.criteria.push_back(criterion);
            }
          },
          "Leave out participants with a smaller proportion of words correct in a condition: "
          "CONDITION=P, like auditory=0.2 (may be repeated)")
      ->allow_extra_args(false);
}

std::vector<TrialsOfFile> read_data(const AnalysisRequest& request) {
  std::vector<TrialsOfFile> files;
  std::vector<std::filesystem::path> stored;
  const auto mapping = request.mapping.empty() ? TrialMapping{} : read_mapping(request.mapping);
  for (const auto& file : request.data) {
    if (lower_case(file.extension().string()) != ".csv") {
      stored.push_back(file);
    } else {
      files.push_back(read_trials(file, mapping));
    }
  }
  if (!request.mapping.empty() && files.empty()) {
    throw Error{"--mapping tells how trials as CSV are read, but none of the data is CSV"};
  }
  auto sessions = trials_of(read_stored_files(stored));
  std::ranges::move(sessions, std::back_inserter(files));
  return files;
}

void warn_of_unpronounced(const Pronounced& counts, Dataset& dataset) {
  if (counts.lacking > 0) {
    dataset.warnings.push_back(
        fmt::format("{} a stimulus that no lexicon or dictionary here has: scored by spelling, "
                    "left out of phoneme scores.",
                    counts.lacking == 1 ? "1 trial presents"
                                        : fmt::format("{} trials present", counts.lacking)));
  }
  if (counts.ambiguous > 0) {
    dataset.warnings.push_back(
        fmt::format("{} a stimulus that can be said in several ways; the first is taken. A column "
                    "\"phones\" tells how it was said.",
                    counts.ambiguous == 1 ? "1 trial presents"
                                          : fmt::format("{} trials present", counts.ambiguous)));
  }
}

std::filesystem::path dictionary_file(const AnalysisRequest& request) {
  if (!request.lexicon.empty()) return request.lexicon;
  return request.dictionary.empty() ? Dictionary::installed() : request.dictionary;
}

}  // namespace

void add_analysis_options(CLI::App& verb, AnalysisRequest& request) {
  verb.add_option("DATA",
                  request.data,
                  "Data files written by bimodal run or bimodal rehearse, or trials as CSV")
      ->required();
  verb.add_flag(
      "--include-practice", request.selection.include_practice, "Analyse the practice trials too");
  verb.add_flag("--exclude-flagged",
                request.selection.exclude_flagged,
                "Leave out trials whose timing was not as planned");
  verb.add_flag("--exclude-simulated",
                request.selection.exclude_simulated,
                "Leave out answers of simulated observers");
  verb.add_option("--participant",
                  request.selection.participants,
                  "Only this participant (may be repeated)")
      ->allow_extra_args(false);
  add_exclusion_options(verb, request);
  verb.add_option(
      "--mapping", request.mapping, "JSON that tells which columns of trials as CSV mean what");
  verb.add_option("--lexicon",
                  request.lexicon,
                  "How words are said, as CSV with the columns word and phonemes; instead of the "
                  "dictionary");
  verb.add_option("--dictionary",
                  request.dictionary,
                  "Pronouncing dictionary in CMU format [the installed pocketsphinx-en-us]");
  add_scoring_options(verb, request.rules);
}

Dictionary dictionary_of(const AnalysisRequest& request) {
  const auto file = dictionary_file(request);
  return request.lexicon.empty() ? Dictionary{file} : read_lexicon(file);
}

Results analyse_request(const AnalysisRequest& request, Console console) {
  ProgressLine progress{console};
  progress.show("reading " + counted(request.data.size(), "data file"));
  auto dataset = gather(read_data(request), request.selection);
  const auto file = dictionary_file(request);
  progress.show(fmt::format("reading {}", file.string()));
  const auto dictionary = dictionary_of(request);
  warn_of_unpronounced(pronounce_stimuli(dataset.trials, dictionary), dataset);
  return analyse(std::move(dataset),
                 dictionary,
                 {.file = file.string(), .sha256 = sha256_of_file(file)},
                 {.rules = request.rules,
                  .bootstrap = request.bootstrap,
                  .criteria = request.criteria,
                  .faces = request.faces,
                  .comparison = request.comparison,
                  .progress = [&](std::string_view step) { progress.show(step); }});
}

void add_idle_resampling(CLI::App& verb) {
  for (const std::string name : {"--seed", "--resamples"}) {
    verb.add_option_function<std::uint64_t>(
        name, [](std::uint64_t) {}, "Taken by every verb; this one draws nothing at random");
  }
}

void add_seed_option(CLI::App& verb, Seed& seed) {
  verb.add_option("--seed", seed, "Of what is drawn at random: the same seed, the same figures")
      ->check(
          CLI::Validator{[](std::string& text) { return whole_number_fault(text, Seed{0}); }, ""})
      ->capture_default_str();
}

std::string nothing_left(const Dataset& dataset) {
  std::string reasons;
  for (const auto& exclusion : dataset.exclusions) {
    if (exclusion.trials == 0) continue;
    reasons +=
        fmt::format("{}{} x {}", reasons.empty() ? "" : ", ", exclusion.trials, exclusion.reason);
  }
  return fmt::format(
      "no trial left to analyse: {} stored in {}{}; check the selection "
      "(--include-practice counts practice trials)",
      dataset.stored_trials,
      counted(dataset.sessions.size(), "session"),
      reasons.empty() ? "" : ", left out: " + reasons);
}

bool is_trial_file(const std::filesystem::path& file, const AnalysisRequest& request) {
  if (lower_case(file.extension().string()) != ".csv") return false;
  return !request.mapping.empty() || is_trial_table(read_file(file));
}

std::string program_name() {
  return fmt::format("bimodal-analysis {}", program_version());
}

std::string_view program_version() {
  return BIMODAL_VERSION;
}

}  // namespace bimodal::analysis
