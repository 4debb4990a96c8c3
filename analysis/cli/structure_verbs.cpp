#include <memory>
#include <utility>

#include "analysis/cli/choice.hpp"
#include "analysis/cli/matrix_source.hpp"
#include "analysis/cli/output_form.hpp"
#include "analysis/report/structure_table.hpp"

namespace bimodal::analysis {

namespace {

struct StructureRequest {
  MatrixChoice choice;
  DissimilarityMeasure measure = DissimilarityMeasure::Phi;
  Linkage linkage = Linkage::Average;
  double criterion = 0.75;
  std::size_t dimensions = 2;
  bool equivalence = false;
  OutputForm form;
};

constexpr const char* kClusterExamples = R"(Examples:
  bimodal-analysis cluster m.csv --linkage average --criterion 0.75
  bimodal-analysis cluster session.sqlite --unit consonant-initial --condition visual --json
  bimodal-analysis cluster m.csv --equivalence --lexicon words.csv

Stimuli whose responses are alike become one class first. The classes are those after the
fewest merges by which every class keeps the criterion's part of the responses to its
members: visemes, if nothing was heard. CSV has the classes, JSON the merges too
(clusters 0 to n-1 are the stimuli, the k-th merge makes cluster n+k).)";

constexpr const char* kMdsExamples = R"(Examples:
  bimodal-analysis mds m.csv
  bimodal-analysis mds m.csv --dimensions 3 --dissimilarity confusion --json

Lays the stimuli out so that those lie near each other whose responses are alike.
Stress-1 tells how far the distances are from the dissimilarities: 0 is perfect.)";

void add_measure(CLI::App& verb, StructureRequest& request) {
  add_choice<DissimilarityMeasure>(
      verb,
      "--dissimilarity",
      request.measure,
      {{"phi", DissimilarityMeasure::Phi}, {"confusion", DissimilarityMeasure::Confusion}},
      "phi: by the whole rows (default); confusion: by how often the two are answered for each "
      "other");
}

ExitCode print_clusters(const StructureRequest& request, Console console) {
  const auto chosen = load_chosen(request.choice, console);
  if (!chosen) return ExitCode::Findings;
  auto table = tabulate_clusters(
      chosen->title, chosen->matrix, request.measure, request.linkage, request.criterion);
  if (request.equivalence) {
    std::vector<std::vector<std::string>> classes;
    for (const auto& made : table.classes) classes.push_back(made.members);
    table.lexicon = lexical_equivalence(dictionary_of(request.choice.analysis), classes);
  }
  return print_as(request.form,
                  {.text = [&] { return cluster_text(table); },
                   .csv = [&] { return cluster_csv(table); },
                   .json = [&] { return cluster_json(table); }},
                  chosen->provenance,
                  chosen->warnings,
                  console);
}

ExitCode print_layout(const StructureRequest& request, Console console) {
  const auto chosen = load_chosen(request.choice, console);
  if (!chosen) return ExitCode::Findings;
  const auto unlike = dissimilarities(chosen->matrix, request.measure);
  const LayoutTable table{.title = chosen->title,
                          .measure = request.measure,
                          .labels = unlike.labels(),
                          .layout = scale_classically(unlike, request.dimensions)};
  return print_as(request.form,
                  {.text = [&] { return layout_text(table); },
                   .csv = [&] { return layout_csv(table); },
                   .json = [&] { return layout_json(table); }},
                  chosen->provenance,
                  chosen->warnings,
                  console);
}

}  // namespace

void add_cluster_verb(CLI::App& program, Verb& chosen) {
  const auto request = std::make_shared<StructureRequest>();
  auto* const verb =
      program.add_subcommand("cluster", "Which stimuli are alike: clusters, and visemes");
  verb->footer(kClusterExamples);
  add_matrix_options(*verb, request->choice);
  add_measure(*verb, *request);
  add_choice<Linkage>(
      *verb,
      "--linkage",
      request->linkage,
      {{"single", Linkage::Single}, {"complete", Linkage::Complete}, {"average", Linkage::Average}},
      "How unlike clusters are: as their nearest members, their farthest, or all "
      "on average (default)");
  verb->add_option("--criterion",
                   request->criterion,
                   "What every class must keep of the responses to its members")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1.0));
  verb->add_flag(
      "--equivalence",
      request->equivalence,
      "How much of the lexicon (--lexicon, --dictionary) is told apart by these classes");
  add_idle_resampling(*verb);
  add_output_form(*verb, request->form);
  verb->callback([request, &chosen] {
    chosen = [request](Console console) { return print_clusters(*request, console); };
  });
}

void add_mds_verb(CLI::App& program, Verb& chosen) {
  const auto request = std::make_shared<StructureRequest>();
  auto* const verb =
      program.add_subcommand("mds", "Where the stimuli lie if alike ones lie near each other");
  verb->footer(kMdsExamples);
  add_matrix_options(*verb, request->choice);
  add_measure(*verb, *request);
  verb->add_option("--dimensions", request->dimensions, "Of the layout")
      ->capture_default_str()
      ->check(CLI::Range(1, 10));
  add_idle_resampling(*verb);
  add_output_form(*verb, request->form);
  verb->callback([request, &chosen] {
    chosen = [request](Console console) { return print_layout(*request, console); };
  });
}

}  // namespace bimodal::analysis
