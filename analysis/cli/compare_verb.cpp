#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "analysis/cli/matrix_source.hpp"
#include "analysis/cli/output_form.hpp"
#include "analysis/data/matrix_file.hpp"
#include "analysis/report/comparison_table.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::analysis {

namespace {

struct CompareRequest {
  AnalysisRequest analysis;
  std::string unit;  ///< empty: initial consonants
  std::string one;
  std::string other;
  Resampling resampling;
  OutputForm form;
};

constexpr const char* kExamples = R"(Examples:
  bimodal-analysis compare natural.csv synthetic.csv
  bimodal-analysis compare P*.sqlite --natural visual-natural --synthetic visual-synthetic
  bimodal-analysis compare trials.csv --lexicon words.csv --natural vn --synthetic vs \
      --unit vowel --resamples 100000 --json

How alike the confusions of two conditions are, the first (natural) being what the second
(synthetic) is measured by: how much is right; correlation of the cells, against what one
face reaches with itself; root mean square difference; per stimulus Jensen-Shannon
divergence and chi-square; Mantel's test; and the test that counts, in which the conditions
are dealt again as the design dealt them: within participant x word where words repeat,
else between the participants. From two matrices of counts everything but this last.
In words and in order: which contrasts the synthetic face fails to show.)";

struct Compared {
  FaceComparison comparison;
  Provenance provenance;
  std::vector<std::string> warnings;
};

Compared compare_files(const CompareRequest& request) {
  const auto& files = request.analysis.data;
  if (files.size() != 2) {
    throw Error{
        fmt::format("comparing confusion matrices: {} given; name two, the natural face's "
                    "first, or trials with --natural and --synthetic",
                    files.size() == 1 ? "one is" : "more than two are")};
  }
  if (!request.one.empty() || !request.other.empty() || !request.unit.empty()) {
    throw Error{
        "comparing confusion matrices: --natural, --synthetic and --unit choose conditions of "
        "trials; "
        "leave them out: of two matrices the first is the natural face's"};
  }
  const auto one = read_titled_matrix(files[0]);
  const auto other = read_titled_matrix(files[1]);
  for (const auto* const read : {&one, &other}) {
    if (read->matrix.total() > 0.0) continue;
    throw Error{fmt::format("comparing confusion matrices: '{}' has no responses",
                            files[read == &one ? 0 : 1].string())};
  }
  Compared compared{.comparison = compare_faces(one.matrix, other.matrix, request.resampling)};
  compared.comparison.one = one.title.empty() ? files[0].string() : one.title;
  compared.comparison.other = other.title.empty() ? files[1].string() : other.title;
  compared.provenance = {.program = program_name(),
                         .files = {{files[0].string(), sha256_of_file(files[0])},
                                   {files[1].string(), sha256_of_file(files[1])}}};
  compared.warnings = one.warnings;
  compared.warnings.insert(compared.warnings.end(), other.warnings.begin(), other.warnings.end());
  return compared;
}

Unit unit_of(const CompareRequest& request) {
  return unit_from_name(request.unit).value_or(Unit::ConsonantInitial);
}

/// Absent, and said why, if no trial is left.
std::optional<Compared> compare_conditions(const CompareRequest& request, Console console) {
  const auto results = analyse_request(request.analysis, console);
  if (results.dataset.trials.empty()) {
    console.err << "bimodal-analysis: " << nothing_left(results.dataset) << '\n';
    return std::nullopt;
  }
  Compared compared{.comparison = compare_faces(
                        results, unit_of(request), request.one, request.other, request.resampling),
                    .provenance = provenance_of(results.dataset, program_name()),
                    .warnings = results.warnings};
  return compared;
}

ExitCode print_comparison(const CompareRequest& request, Console console) {
  std::optional<Compared> compared;
  const auto& files = request.analysis.data;
  const bool matrices = std::ranges::any_of(
      files, [&](const auto& file) { return is_matrix_file(file, request.analysis); });
  if (matrices) {
    compared = compare_files(request);
  } else if (request.one.empty() || request.other.empty()) {
    throw Error{
        "comparing conditions: which two? Name them with --natural and --synthetic, the one that "
        "the other is measured by first"};
  } else {
    compared = compare_conditions(request, console);
  }
  if (!compared) return ExitCode::Findings;
  compared->provenance.seed = request.resampling.seed;
  compared->provenance.resamples = request.resampling.permutations;
  const auto& comparison = compared->comparison;
  return print_as(request.form,
                  {.text = [&] { return comparison_text(comparison); },
                   .csv = [&] { return comparison_csv(comparison); },
                   .json = [&] { return comparison_json(comparison); }},
                  compared->provenance,
                  compared->warnings,
                  console);
}

}  // namespace

void add_compare_verb(CLI::App& program, Verb& chosen) {
  const auto request = std::make_shared<CompareRequest>();
  auto* const verb =
      program.add_subcommand("compare", "How alike two faces are: their confusions compared");
  verb->footer(kExamples);
  request->analysis.bootstrap.draws = 0;
  add_analysis_options(*verb, request->analysis);
  verb->get_option("DATA")->description(
      "Two confusion matrices as CSV, the natural face's first; or data files of sessions, or "
      "trials as CSV");
  verb->add_option("--natural", request->one, "Condition that the other is measured by");
  verb->add_option("--synthetic", request->other, "Condition that is measured");
  std::vector<std::string> units;
  for (const auto unit : kUnits) units.emplace_back(name(unit));
  verb->add_option("--unit", request->unit, "What of the words, of trials")
      ->check(CLI::IsMember(units))
      ->default_str("consonant-initial");
  verb->add_option("--resamples", request->resampling.permutations, "Permutations, and bootstraps")
      ->check(CLI::Range(100, 10'000'000))
      ->capture_default_str();
  add_seed_option(*verb, request->resampling.seed);
  add_output_form(*verb, request->form);
  verb->callback([request, &chosen] {
    chosen = [request](Console console) { return print_comparison(*request, console); };
  });
}

}  // namespace bimodal::analysis
