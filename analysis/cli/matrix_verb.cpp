#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/cli/verb.hpp"
#include "analysis/report/matrix_text.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::analysis {

namespace {

struct MatrixRequest {
  AnalysisRequest analysis;
  std::string unit;
  std::string condition;
  bool csv = false;
};

constexpr const char* kExamples = R"(Examples:
  bimodal-analysis matrix session.sqlite --unit vowel --condition visual
  bimodal-analysis matrix session.sqlite --unit consonant-initial --condition bimodal --csv > m.csv

Rows are the phones presented, columns those answered, then "deleted" (nothing of
the answer stands in this place), "blank" (no answer) and "other" (the answer is not
in the dictionary). All conditions of the data have the same rows and columns.)";

const UnitConfusions& find_table(const Results& results, const MatrixRequest& request) {
  std::vector<std::string> names;
  for (const auto& condition : results.conditions) names.push_back(condition.name);
  const bool only = request.condition.empty() && names.size() == 1;
  const auto& wanted = only ? names.front() : request.condition;
  const auto found = std::ranges::find_if(results.confusions, [&](const UnitConfusions& table) {
    return name(table.unit) == request.unit && table.condition == wanted;
  });
  if (found != results.confusions.end()) return *found;
  throw Error{fmt::format("printing a confusion matrix: {}; choose with --condition one of: {}",
                          wanted.empty() ? std::string{"the data have several conditions"}
                                         : fmt::format("the data have no condition \"{}\"", wanted),
                          fmt::join(names, ", "))};
}

ExitCode print_matrix(const MatrixRequest& request, Console console) {
  const auto results = analyse_request(request.analysis, console);
  if (results.dataset.trials.empty()) {
    console.err << "bimodal-analysis: " << nothing_left(results.dataset) << '\n';
    return ExitCode::Findings;
  }
  const auto& table = find_table(results, request);
  console.out << (request.csv ? matrix_csv(table.matrix) : matrix_text(table)) << std::flush;
  for (const auto& warning : results.dataset.warnings) {
    console.err << "warning: " << warning << '\n';
  }
  const bool simulated = std::ranges::any_of(results.dataset.trials, &Trial::simulated);
  if (simulated) console.err << "warning: SIMULATED sessions are among the data\n";
  return ExitCode::Done;
}

}  // namespace

void add_matrix_verb(CLI::App& program, Verb& chosen) {
  const auto request = std::make_shared<MatrixRequest>();
  request->analysis.bootstrap.draws = 0;  // a matrix of counts has no intervals
  auto* const verb =
      program.add_subcommand("matrix", "Print one confusion matrix: proportions, or counts as CSV");
  verb->footer(kExamples);
  add_analysis_options(*verb, request->analysis);
  verb->add_option("--unit", request->unit, "Which phones of the words")
      ->required()
      ->check(CLI::IsMember({"consonant-initial", "vowel", "consonant-final"}));
  verb->add_option(
      "--condition", request->condition, "Which condition; needed if there are several");
  verb->add_flag("--csv", request->csv, "Counts as CSV: stimulus, then one column per response");
  verb->callback([request, &chosen] {
    chosen = [request](Console console) { return print_matrix(*request, console); };
  });
}

}  // namespace bimodal::analysis
