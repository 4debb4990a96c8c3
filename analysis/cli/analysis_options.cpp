#include <fmt/format.h>

#include "analysis/cli/scoring_options.hpp"
#include "analysis/cli/verb.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/digest.hpp"

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

}  // namespace

void add_analysis_options(CLI::App& verb, AnalysisRequest& request) {
  verb.add_option("DATA", request.data, "Data files written by bimodal run or bimodal rehearse")
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
  verb.add_option("--dictionary",
                  request.dictionary,
                  "Pronouncing dictionary in CMU format [the installed pocketsphinx-en-us]");
  add_scoring_options(verb, request.rules);
}

Results analyse_request(const AnalysisRequest& request, Console console) {
  ProgressLine progress{console};
  progress.show("reading " + counted(request.data.size(), "data file"));
  auto dataset = gather_trials(read_stored_files(request.data), request.selection);
  const auto file = request.dictionary.empty() ? Dictionary::installed() : request.dictionary;
  progress.show(fmt::format("reading {}", file.string()));
  const Dictionary dictionary{file};
  return analyse(std::move(dataset),
                 dictionary,
                 {.file = file.string(), .sha256 = sha256_of_file(file)},
                 {.rules = request.rules,
                  .bootstrap = request.bootstrap,
                  .progress = [&](std::string_view step) { progress.show(step); }});
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

std::string_view program_version() {
  return BIMODAL_VERSION;
}

}  // namespace bimodal::analysis
