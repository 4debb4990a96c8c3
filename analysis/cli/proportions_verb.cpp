#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/cli/output_form.hpp"
#include "analysis/cli/verb.hpp"
#include "analysis/report/benefit_table.hpp"
#include "analysis/report/counted_proportions.hpp"
#include "analysis/report/proportion_table.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/lower_case.hpp"

namespace bimodal::analysis {

namespace {

struct ProportionsRequest {
  AnalysisRequest analysis;
  std::optional<double> level;
  std::optional<int> alternatives;
  bool by_participant = false;
  OutputForm form;
};

constexpr const char* kExamples = R"(Examples:
  bimodal-analysis proportions P*.sqlite
  bimodal-analysis proportions trials.csv --lexicon words.csv --by-participant --resamples 10000
  bimodal-analysis proportions counts.csv --level 0.99 --json
  bimodal-analysis proportions choices.csv --alternatives 4
  bimodal-analysis proportions yesno.csv

Of sessions and trials: words, phonemes and units correct in each condition. Pooled over
participants an interval comes from a bootstrap over participants and words; of one
participant it is Wilson's. What a face adds to a voice (AV - A and the like), and what part
of the natural face's benefit a synthetic one gives, where the data say who was heard and
seen (columns auditory_talker, visual_talker, snr_db).

Of counts: a CSV with a column k (successes), a column n (trials) and any others, like
condition,k,n and visual,86,414. Each line gets five intervals for independent trials: of
trials pooled over participants or words these are far too narrow. --alternatives adds d'
of a choice among so many. A CSV with the columns hits, signals, false_alarms and noises
gets d' and criterion.)";

CountsKind kind_of(const ProportionsRequest& request) {
  const auto& files = request.analysis.data;
  if (files.size() != 1 || !request.analysis.mapping.empty()) return CountsKind::None;
  if (lower_case(files.front().extension().string()) != ".csv") return CountsKind::None;
  return kind_of_counts(read_file(files.front()));
}

Provenance provenance_of_counts(const ProportionsRequest& request) {
  const auto& file = request.analysis.data.front();
  return {.program = program_name(), .files = {{file.string(), sha256_of_file(file)}}};
}

ExitCode print_counts(const ProportionsRequest& request, Console console) {
  const auto table = estimate_counts(read_counts(request.analysis.data.front()),
                                     request.level.value_or(0.95),
                                     request.alternatives);
  return print_as(request.form,
                  {.text = [&] { return counted_proportions_text(table); },
                   .csv = [&] { return counted_proportions_csv(table); },
                   .json = [&] { return counted_proportions_json(table); }},
                  provenance_of_counts(request),
                  {},
                  console);
}

ExitCode print_yes_counts(const ProportionsRequest& request, Console console) {
  const auto table = read_yes_counts(request.analysis.data.front());
  return print_as(request.form,
                  {.text = [&] { return yes_no_text(table); },
                   .csv = [&] { return yes_no_csv(table); },
                   .json = [&] { return yes_no_json(table); }},
                  provenance_of_counts(request),
                  {},
                  console);
}

/// Options that mean something for trials only.
void require_counts_only(const ProportionsRequest& request) {
  const auto& analysis = request.analysis;
  if (!request.by_participant && analysis.lexicon.empty() && analysis.dictionary.empty() &&
      analysis.criteria.empty() && analysis.rules == ScoringRules{}) {
    return;
  }
  throw Error{fmt::format(
      "'{}' is a table of counts, which has no trials; leave out --by-participant, --lexicon, "
      "--dictionary, --at-least and the rules of scoring",
      analysis.data.front().string())};
}

ExitCode print_trials(const ProportionsRequest& request, Console console) {
  if (request.level) {
    throw Error{
        "--level is for tables of counts; proportions of trials have intervals of 95 %; leave it "
        "out"};
  }
  const auto results = analyse_request(request.analysis, console);
  if (results.dataset.trials.empty()) {
    console.err << "bimodal-analysis: " << nothing_left(results.dataset) << '\n';
    return ExitCode::Findings;
  }
  ProportionTable table{.rows = results.pooled, .alternatives = request.alternatives};
  if (request.by_participant) {
    table.rows.insert(table.rows.end(), results.individual.begin(), results.individual.end());
  }
  auto provenance = provenance_of(results.dataset, program_name());
  provenance.seed = request.analysis.bootstrap.seed;
  provenance.resamples = request.analysis.bootstrap.draws;
  return print_as(
      request.form,
      {.text =
           [&] { return proportion_text(table) + benefit_text(results.benefits, results.shares); },
       .csv = [&] { return proportion_csv(table); },
       .json =
           [&] {
             nlohmann::ordered_json json{{"level", 0.95}};
             json["proportions"] = proportion_json(table);
             json["benefits"] = benefit_json(results.benefits);
             json["shares_of_natural_benefit"] = share_json(results.shares);
             return json.dump(2);
           }},
      provenance,
      results.warnings,
      console);
}

ExitCode print_proportions(const ProportionsRequest& request, Console console) {
  switch (kind_of(request)) {
    case CountsKind::Successes:
      require_counts_only(request);
      return print_counts(request, console);
    case CountsKind::Yes:
      require_counts_only(request);
      if (request.alternatives) {
        throw Error{"--alternatives is for choices (columns k and n), not for yes and no"};
      }
      return print_yes_counts(request, console);
    case CountsKind::None:
      break;
  }
  return print_trials(request, console);
}

}  // namespace

void add_proportions_verb(CLI::App& program, Verb& chosen) {
  const auto request = std::make_shared<ProportionsRequest>();
  auto* const verb = program.add_subcommand(
      "proportions", "Proportions correct with intervals, d'; of trials, or of counts k of n");
  verb->footer(kExamples);
  add_analysis_options(*verb, request->analysis);
  verb->get_option("DATA")->description(
      "Data files of sessions, trials as CSV, or one CSV of counts: columns k and n, or hits, "
      "signals, false_alarms and noises");
  verb->add_option("--level", request->level, "Of confidence, of counts")
      ->check(CLI::Range(0.5, 0.9999))
      ->default_str("0.95");
  verb->add_option("--alternatives", request->alternatives, "Of a choice: adds d'")
      ->check(CLI::Range(2, 1000));
  verb->add_flag("--by-participant", request->by_participant, "A row for each participant too");
  verb->add_option("--resamples", request->analysis.bootstrap.draws, "Bootstrap draws")
      ->capture_default_str()
      ->check(CLI::Range(100, 1'000'000));
  add_seed_option(*verb, request->analysis.bootstrap.seed);
  add_output_form(*verb, request->form);
  verb->callback([request, &chosen] {
    chosen = [request](Console console) { return print_proportions(*request, console); };
  });
}

}  // namespace bimodal::analysis
