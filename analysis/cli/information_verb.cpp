#include <memory>

#include "analysis/cli/matrix_source.hpp"
#include "analysis/cli/output_form.hpp"
#include "analysis/data/feature_file.hpp"
#include "analysis/report/information_table.hpp"

namespace bimodal::analysis {

namespace {

struct InformationRequest {
  MatrixChoice choice;
  std::filesystem::path features;
  Seed seed = 1;
  std::int64_t draws = kTransmissionDraws;
  bool no_intervals = false;
  OutputForm form;
};

constexpr const char* kExamples = R"(Examples:
  bimodal-analysis information m.csv
  bimodal-analysis information m.csv --features f.csv --json
  bimodal-analysis information session.sqlite --unit consonant-initial --condition visual

Entropies of stimuli H(x) and responses H(y), and what was transmitted, T, in bits. Of
few responses T is too large; it is printed with three corrections. An interval is given
only if intervals like it cover the truth in at least 90 % of studies simulated at these
counts. Per feature, what was transmitted of it: responses that have no value of the
feature ("blank", say) are left out, and counted.

The file of features: a line with their names, like label,voicing,place, then a line per
label, like p,voiceless,labial.)";

/// Only where responses may be taken for independent.
IntervalRequest intervals_of(const InformationRequest& request, const ChosenMatrix& chosen) {
  if (request.no_intervals) return {.seed = std::nullopt, .why_none = "none was asked for"};
  if (chosen.participants > 1) {
    return {.seed = std::nullopt,
            .why_none =
                "responses of one participant are alike, and of no method is it known that "
                "it covers\nwhat it says for several participants put together; choose one "
                "with --participant"};
  }
  return {.seed = request.seed, .draws = request.draws, .why_none = {}};
}

ExitCode print_information(const InformationRequest& request, Console console) {
  auto chosen = load_chosen(request.choice, console);
  if (!chosen) return ExitCode::Findings;
  const auto features = request.features.empty() ? FeatureTable{} : read_features(request.features);
  const auto table =
      tabulate_information(chosen->title, chosen->matrix, features, intervals_of(request, *chosen));
  if (table.interval) {
    chosen->provenance.seed = request.seed;
    chosen->provenance.resamples = request.draws;
  }
  return print_as(request.form,
                  {.text = [&] { return information_text(table); },
                   .csv = [&] { return information_csv(table); },
                   .json = [&] { return information_json(table); }},
                  chosen->provenance,
                  chosen->warnings,
                  console);
}

}  // namespace

void add_information_verb(CLI::App& program, Verb& chosen) {
  const auto request = std::make_shared<InformationRequest>();
  auto* const verb = program.add_subcommand(
      "information", "How much of the stimuli, and of each of their features, came through");
  verb->footer(kExamples);
  add_matrix_options(*verb, request->choice);
  verb->add_option("--features", request->features, "What the sounds are like, as CSV");
  add_seed_option(*verb, request->seed);
  verb->add_option("--resamples", request->draws, "Matrices drawn for each interval")
      ->check(CLI::Range(99, 100'000))
      ->capture_default_str();
  verb->add_flag("--no-intervals", request->no_intervals, "Without intervals, which take a while");
  add_output_form(*verb, request->form);
  verb->callback([request, &chosen] {
    chosen = [request](Console console) { return print_information(*request, console); };
  });
}

}  // namespace bimodal::analysis
