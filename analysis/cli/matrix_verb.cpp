#include <memory>

#include "analysis/cli/matrix_source.hpp"
#include "analysis/report/matrix_text.hpp"

namespace bimodal::analysis {

namespace {

struct MatrixRequest {
  MatrixChoice choice;
  bool csv = false;
};

constexpr const char* kExamples = R"(Examples:
  bimodal-analysis matrix session.sqlite --unit vowel --condition visual
  bimodal-analysis matrix session.sqlite --unit consonant-initial --condition bimodal --csv > m.csv

Rows are the phones presented, columns those answered, then "deleted" (nothing of
the answer stands in this place), "blank" (no answer) and "other" (the answer is not
in the dictionary). All conditions of the data have the same rows and columns. Onsets
and codas are whole clusters ("S T"; "none" has no consonant), phonemes all phones
wherever they stand, words are compared as they are spelled.)";

ExitCode print_matrix(const MatrixRequest& request, Console console) {
  ChosenMatrix chosen;
  const auto table = tabulate_chosen(request.choice, console, chosen);
  if (!table) return ExitCode::Findings;
  console.out << (request.csv ? matrix_csv(table->matrix) : matrix_text(*table)) << std::flush;
  for (const auto& warning : chosen.warnings) console.err << "warning: " << warning << '\n';
  return ExitCode::Done;
}

}  // namespace

void add_matrix_verb(CLI::App& program, Verb& chosen) {
  const auto request = std::make_shared<MatrixRequest>();
  auto* const verb =
      program.add_subcommand("matrix", "Print one confusion matrix: proportions, or counts as CSV");
  verb->footer(kExamples);
  add_matrix_options(*verb, request->choice);
  verb->get_option("DATA")->description("Data files written by bimodal run or bimodal rehearse");
  verb->get_option("--unit")->required();
  verb->add_flag("--csv", request->csv, "Counts as CSV: stimulus, then one column per response");
  verb->callback([request, &chosen] {
    chosen = [request](Console console) { return print_matrix(*request, console); };
  });
}

}  // namespace bimodal::analysis
