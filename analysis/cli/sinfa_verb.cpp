#include <memory>

#include "analysis/cli/matrix_source.hpp"
#include "analysis/cli/output_form.hpp"
#include "analysis/data/feature_file.hpp"
#include "analysis/report/sinfa_table.hpp"

namespace bimodal::analysis {

namespace {

struct SinfaRequest {
  MatrixChoice choice;
  std::filesystem::path features;
  OutputForm form;
};

constexpr const char* kExamples = R"(Examples:
  bimodal-analysis sinfa m.csv --features f.csv
  bimodal-analysis sinfa session.sqlite --unit consonant-initial --condition visual \
      --features f.csv --json

In each round the feature of which the largest part came through is held: from then on
only responses count that agree with their stimulus in it. So features that go together
(what is nasal is voiced) are not counted twice. Features that tie are held together.

The file of features: a line with their names, like label,voicing,place, then a line per
label, like p,voiceless,labial.)";

ExitCode print_sinfa(const SinfaRequest& request, Console console) {
  const auto features = read_features(request.features);
  const auto chosen = load_chosen(request.choice, console);
  if (!chosen) return ExitCode::Findings;
  const auto found = analyse_sequentially(chosen->matrix, features);
  return print_as(request.form,
                  {.text = [&] { return sinfa_text(chosen->title, found); },
                   .csv = [&] { return sinfa_csv(found); },
                   .json = [&] { return sinfa_json(chosen->title, found); }},
                  chosen->provenance,
                  chosen->warnings,
                  console);
}

}  // namespace

void add_sinfa_verb(CLI::App& program, Verb& chosen) {
  const auto request = std::make_shared<SinfaRequest>();
  auto* const verb = program.add_subcommand(
      "sinfa", "What each feature adds to those that came through best: sequential analysis");
  verb->footer(kExamples);
  add_matrix_options(*verb, request->choice);
  verb->add_option("--features", request->features, "What the sounds are like, as CSV")->required();
  add_idle_resampling(*verb);
  add_output_form(*verb, request->form);
  verb->callback([request, &chosen] {
    chosen = [request](Console console) { return print_sinfa(*request, console); };
  });
}

}  // namespace bimodal::analysis
