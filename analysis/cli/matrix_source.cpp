#include "analysis/cli/matrix_source.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/data/matrix_file.hpp"
#include "analysis/report/matrix_text.hpp"
#include "analysis/report/structure_table.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/lower_case.hpp"

namespace bimodal::analysis {

namespace {

constexpr std::array<std::string_view, 7> kMatrixEndings{
    ".csv", ".json", ".confusion", ".contingencytable", ".tableofreal", ".praat", ".txt"};

bool has_matrix_ending(const std::filesystem::path& file) {
  const auto ending = lower_case(file.extension().string());
  return std::ranges::find(kMatrixEndings, ending) != kMatrixEndings.end();
}

std::vector<std::string> unit_names() {
  std::vector<std::string> names;
  for (const Unit unit : kUnits) names.emplace_back(name(unit));
  return names;
}

UnitConfusions find_table(const Results& results, const MatrixChoice& choice) {
  std::vector<std::string> names;
  for (const auto& condition : results.conditions) names.push_back(condition.name);
  const bool only = choice.condition.empty() && names.size() == 1;
  const auto& wanted = only ? names.front() : choice.condition;
  auto tables = tabulate_unit(
      results.dataset.trials, results.scores, names, unit_from_name(choice.unit).value());
  const auto found = std::ranges::find(tables, wanted, &UnitConfusions::condition);
  if (found != tables.end()) return std::move(*found);
  throw Error{fmt::format("choosing a confusion matrix: {}; choose with --condition one of: {}",
                          wanted.empty() ? std::string{"the data have several conditions"}
                                         : fmt::format("the data have no condition \"{}\"", wanted),
                          fmt::join(names, ", "))};
}

/// Options that a matrix of counts leaves nothing to choose by.
void require_no_choice(const MatrixChoice& choice) {
  if (choice.analysis.data.size() > 1) {
    throw Error{
        "choosing a confusion matrix: several files, one of them a matrix; name one matrix, or "
        "data files of sessions only"};
  }
  const auto& selection = choice.analysis.selection;
  const bool chooses = !choice.unit.empty() || !choice.condition.empty() ||
                       selection.include_practice || selection.exclude_flagged ||
                       selection.exclude_simulated || !selection.participants.empty() ||
                       choice.analysis.rules != ScoringRules{};
  if (!chooses) return;
  throw Error{fmt::format(
      "'{}' is a matrix of counts, which has no trials to choose from; leave out --unit, "
      "--condition, --participant, --include-practice, --exclude-... and the rules of scoring",
      choice.analysis.data.front().string())};
}

ClassMap clusters_of(const ConfusionMatrix& matrix) {
  constexpr double kKept = 0.75;
  ClassMap map{.name = "clusters",
               .source = "average linkage of phi; every class keeps .75 of its responses",
               .classes = {}};
  const auto table =
      tabulate_clusters("", matrix, DissimilarityMeasure::Phi, Linkage::Average, kKept);
  for (const auto& made : table.classes) {
    const auto name = fmt::format("{}", fmt::join(made.members, " "));
    for (const auto& member : made.members) map.classes.emplace(member, name);
  }
  return map;
}

ClassMap classes_named(const std::string& name, const ConfusionMatrix& matrix) {
  if (name == "clusters") return clusters_of(matrix);
  if (auto preset = preset_classes(name)) return std::move(*preset);
  if (lower_case(std::filesystem::path{name}.extension().string()) == ".csv") {
    return read_classes(name);
  }
  throw Error{fmt::format(
      "putting labels together: there are no classes \"{}\"; give clusters, a CSV with the columns "
      "label and class, or one of: {}",
      name,
      fmt::join(preset_class_names(), ", "))};
}

void combine(const std::string& classes, ChosenMatrix& chosen) {
  chosen.uncombined = chosen.matrix;
  if (classes.empty()) return;
  chosen.classes = classes_named(classes, chosen.matrix);
  chosen.matrix = matrix_of_classes(chosen.matrix, *chosen.classes);
  chosen.title += fmt::format(", classes {}", chosen.classes->name);
}

}  // namespace

void add_matrix_options(CLI::App& verb, MatrixChoice& choice) {
  choice.analysis.bootstrap.draws = 0;  // a matrix of counts has no intervals
  add_analysis_options(verb, choice.analysis);
  verb.get_option("DATA")->description(
      "Data files written by bimodal run or bimodal rehearse, trials as CSV, or one confusion "
      "matrix: as CSV (first column stimulus, then one column of counts per response; or "
      "stimulus,response,count), as JSON, or as a Confusion of Praat");
  verb.add_option("--unit", choice.unit, "What is taken as one stimulus; needed of sessions")
      ->check(CLI::IsMember(unit_names()));
  verb.add_option(
      "--condition", choice.condition, "Which condition of sessions; needed if there are several");
  verb.add_option("--classes",
                  choice.classes,
                  "Put labels together: owens-blazek (visemes), place, manner, voicing, clusters "
                  "(of the matrix itself), or a CSV with the columns label and class");
}

bool is_matrix_file(const std::filesystem::path& file, const AnalysisRequest& request) {
  if (std::filesystem::is_directory(file)) {
    throw Error{fmt::format("cannot read '{}': it is a folder; name a file", file.string())};
  }
  return has_matrix_ending(file) && !is_trial_file(file, request);
}

bool chooses_matrix_file(const MatrixChoice& choice) {
  const bool any = std::ranges::any_of(choice.analysis.data, [&](const auto& file) {
    return is_matrix_file(file, choice.analysis);
  });
  if (any) require_no_choice(choice);
  return any;
}

std::optional<UnitConfusions> tabulate_chosen(const MatrixChoice& choice,
                                              Console console,
                                              ChosenMatrix& chosen) {
  if (choice.unit.empty()) {
    throw Error{
        fmt::format("choosing a confusion matrix: which phones of the words? Give --unit, one of: "
                    "{}",
                    fmt::join(unit_names(), ", "))};
  }
  const auto results = analyse_request(choice.analysis, console);
  if (results.dataset.trials.empty()) {
    console.err << "bimodal-analysis: " << nothing_left(results.dataset) << '\n';
    return std::nullopt;
  }
  chosen.provenance = provenance_of(results.dataset, program_name());
  chosen.participants = results.participants.size();
  chosen.warnings = results.dataset.warnings;
  if (std::ranges::any_of(results.dataset.trials, &Trial::simulated)) {
    chosen.warnings.emplace_back("SIMULATED sessions are among the data");
  }
  return find_table(results, choice);
}

std::optional<ChosenMatrix> load_chosen(const MatrixChoice& choice, Console console) {
  ChosenMatrix chosen;
  if (chooses_matrix_file(choice)) {
    const auto& file = choice.analysis.data.front();
    auto read = read_titled_matrix(file);
    chosen.title = read.title.empty() ? file.string() : std::move(read.title);
    chosen.warnings = std::move(read.warnings);
    chosen.matrix = std::move(read.matrix);
    chosen.provenance = {.program = program_name(),
                         .files = {{file.string(), sha256_of_file(file)}}};
  } else {
    auto table = tabulate_chosen(choice, console, chosen);
    if (!table) return std::nullopt;
    chosen.title = fmt::format("{}, condition {}", title(table->unit), table->condition);
    chosen.left_out = left_out_text(*table);
    chosen.matrix = std::move(table->matrix);
  }
  combine(choice.classes, chosen);
  if (chosen.matrix.total() > 0) return chosen;
  console.err << "bimodal-analysis: " << chosen.title << ": the matrix has no responses\n";
  return std::nullopt;
}

}  // namespace bimodal::analysis
