#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/cli/matrix_source.hpp"
#include "analysis/cli/output_form.hpp"
#include "analysis/report/exported_matrix.hpp"
#include "analysis/report/json_count.hpp"
#include "analysis/report/matrix_text.hpp"
#include "analysis/report/printed_number.hpp"

namespace bimodal::analysis {

namespace {

struct MatrixRequest {
  MatrixChoice choice;
  OutputForm form;
};

constexpr const char* kExamples = R"(Examples:
  bimodal-analysis matrix session.sqlite --unit vowel --condition visual
  bimodal-analysis matrix session.sqlite --unit consonant-initial --condition bimodal --csv > m.csv
  bimodal-analysis matrix m.csv --classes owens-blazek
  bimodal-analysis matrix trials.csv --lexicon words.csv --unit word --condition visual --json

Rows are the phones presented, columns those answered, then "deleted" (nothing of
the answer stands in this place), "blank" (no answer) and "other" (the answer is not
in the dictionary). All conditions of the data have the same rows and columns. Onsets
and codas are whole clusters ("S T"; "none" has no consonant), phonemes all phones
wherever they stand, words are compared as they are spelled. With --classes, confusions of
classes (visemes), and below them how well the members of each class are told apart.)";

std::string within_text(const ChosenMatrix& chosen) {
  if (!chosen.classes) return {};
  std::string text = "\nWithin classes: responses within the class that name the right member\n";
  for (const auto& within : within_class_confusions(chosen.uncombined, *chosen.classes)) {
    text += fmt::format("  {:<24} n {:>6}  correct {:>5}  by chance {}\n",
                        within.name,
                        print_count(within.matrix.total()),
                        within.correct ? print_proportion(*within.correct) : "-",
                        print_proportion(within.chance));
  }
  return text;
}

std::string as_json(const ChosenMatrix& chosen) {
  using Json = nlohmann::ordered_json;
  auto json =
      Json::parse(matrix_json({chosen.title, chosen.warnings, chosen.matrix, LabelOrder::Given}));
  json["correct"] = json_count(chosen.matrix.correct());
  json["left_out"] = chosen.left_out;
  if (!chosen.classes) return json.dump(2);
  json["classes"] = {{"name", chosen.classes->name}, {"source", chosen.classes->source}};
  json["within_classes"] = Json::array();
  for (const auto& within : within_class_confusions(chosen.uncombined, *chosen.classes)) {
    auto part = Json::parse(matrix_json({within.name, {}, within.matrix, LabelOrder::Given}));
    json["within_classes"].push_back({{"class", within.name},
                                      {"n", part["n"]},
                                      {"correct", within.correct ? Json(*within.correct) : Json()},
                                      {"chance", within.chance},
                                      {"stimuli", part["stimuli"]},
                                      {"responses", part["responses"]},
                                      {"counts", part["counts"]}});
  }
  return json.dump(2);
}

ExitCode print_matrix(const MatrixRequest& request, Console console) {
  const auto chosen = load_chosen(request.choice, console);
  if (!chosen) return ExitCode::Findings;
  return print_as(request.form,
                  {.text =
                       [&] {
                         return matrix_text(chosen->title, chosen->matrix) + chosen->left_out +
                                within_text(*chosen);
                       },
                   .csv = [&] { return matrix_csv(chosen->matrix); },
                   .json = [&] { return as_json(*chosen); }},
                  chosen->provenance,
                  chosen->warnings,
                  console);
}

}  // namespace

void add_matrix_verb(CLI::App& program, Verb& chosen) {
  const auto request = std::make_shared<MatrixRequest>();
  auto* const verb =
      program.add_subcommand("matrix", "Print one confusion matrix: proportions, or counts as CSV");
  verb->footer(kExamples);
  add_matrix_options(*verb, request->choice);
  add_idle_resampling(*verb);
  add_output_form(*verb, request->form);
  verb->callback([request, &chosen] {
    chosen = [request](Console console) { return print_matrix(*request, console); };
  });
}

}  // namespace bimodal::analysis
