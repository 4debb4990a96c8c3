#include <algorithm>
#include <memory>

#include "analysis/cli/output_form.hpp"
#include "analysis/cli/verb.hpp"
#include "analysis/report/score_table.hpp"
#include "analysis/report/scored_trials.hpp"

namespace bimodal::analysis {

namespace {

struct ScoreRequest {
  AnalysisRequest analysis;
  bool by_participant = false;
  bool trials = false;
  OutputForm form;
};

constexpr const char* kExamples = R"(Examples:
  bimodal-analysis score session.sqlite
  bimodal-analysis score P01.sqlite P02.sqlite --by-participant --csv > scores.csv
  bimodal-analysis score session.sqlite --tolerate plural,tense --ties average --json
  bimodal-analysis score session.sqlite --trials
  bimodal-analysis score trials.csv --lexicon words.csv --json

Without options an answer is correct if it is the word or sounds as was presented. In
spelling, case, accents, spaces, hyphens and punctuation never count. --tolerate:
double-letters ("stuf"), plural ("cats"), tense ("walked", "went"), contractions
("cannot"), numbers ("2"); with compounds an answer of several words ("ice cream")
that the dictionary lacks as one sounds as these, one after the other. All phonemes of
a tolerated answer are correct.)";

std::vector<std::string> names_of(const std::vector<ConditionSummary>& conditions) {
  std::vector<std::string> names;
  for (const auto& condition : conditions) names.push_back(condition.name);
  return names;
}

Renderings render_trials(const Results& results) {
  const auto& trials = results.dataset.trials;
  const auto& scores = results.scores;
  return {.text = [&] { return scored_trials_text(trials, scores); },
          .csv = [&] { return scored_trials_csv(trials, scores); },
          .json = [&] { return scored_trials_json(trials, scores); }};
}

Renderings render_table(const ScoreTable& table) {
  return {.text = [&] { return score_text(table); },
          .csv = [&] { return score_csv(table); },
          .json = [&] { return score_json(table); }};
}

std::vector<std::string> warnings_of(const Dataset& dataset) {
  auto warnings = dataset.warnings;
  if (std::ranges::any_of(dataset.trials, &Trial::simulated)) {
    warnings.emplace_back("SIMULATED sessions are among the data");
  }
  return warnings;
}

ExitCode print_scores(const ScoreRequest& request, Console console) {
  const auto results = analyse_request(request.analysis, console);
  if (results.dataset.trials.empty()) {
    console.err << "bimodal-analysis: " << nothing_left(results.dataset) << '\n';
    return ExitCode::Findings;
  }
  const auto warnings = warnings_of(results.dataset);
  const auto provenance = provenance_of(results.dataset, program_name());
  if (request.trials) {
    return print_as(request.form, render_trials(results), provenance, warnings, console);
  }
  const auto table =
      tabulate_scores(results.dataset.trials,
                      results.scores,
                      names_of(results.conditions),
                      request.by_participant ? results.participants : std::vector<std::string>{},
                      results.rules);
  return print_as(request.form, render_table(table), provenance, warnings, console);
}

}  // namespace

void add_score_verb(CLI::App& program, Verb& chosen) {
  const auto request = std::make_shared<ScoreRequest>();
  request->analysis.bootstrap.draws = 0;  // counts have no intervals
  auto* const verb =
      program.add_subcommand("score", "Print what became of the answers: words and phonemes");
  verb->footer(kExamples);
  add_analysis_options(*verb, request->analysis);
  auto* const by_participant =
      verb->add_flag("--by-participant", request->by_participant, "A row for each participant too");
  verb->add_flag("--trials", request->trials, "One line for each trial, not the counts")
      ->excludes(by_participant);
  add_idle_resampling(*verb);
  add_output_form(*verb, request->form);
  verb->callback([request, &chosen] {
    chosen = [request](Console console) { return print_scores(*request, console); };
  });
}

}  // namespace bimodal::analysis
