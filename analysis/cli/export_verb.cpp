#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "analysis/cli/choice.hpp"
#include "analysis/cli/matrix_source.hpp"
#include "analysis/report/exported_matrix.hpp"
#include "analysis/report/printed_matrix.hpp"
#include "stimuli/base/draft.hpp"

namespace bimodal::analysis {

namespace {

enum class ExportFormat { Csv, Long, Json, Praat, Latex, Markdown };

struct ExportRequest {
  MatrixChoice choice;
  ExportFormat format = ExportFormat::Csv;
  LabelOrder order = LabelOrder::Given;
  bool proportions = false;
  bool bare = false;
  std::string title;
  std::filesystem::path file;  ///< empty: standard output
};

constexpr const char* kExamples = R"(Examples:
  bimodal-analysis export session.sqlite --unit vowel --condition visual --format csv -o v.csv
  bimodal-analysis export v.csv --format praat -o v.Confusion
  bimodal-analysis export v.csv --format latex --order clusters --title 'Vowels, face alone'
  bimodal-analysis export v.csv --format csv --proportions

Formats: csv (a table of counts), long (a line for each stimulus and response), json,
praat (a Confusion that Praat opens), latex (APA, with booktabs), markdown. All say title,
orientation, order and n; all but csv and praat have counts and row proportions, csv has
one of the two, praat counts. Counts in csv, long, json and praat are in full precision,
and every verb here reads them back (name the file .csv, .json, .Confusion or .txt).

The facts before CSV stand in lines that begin with "# " (leave them out with --bare):
  R       read.csv("v.csv", comment.char = "#", check.names = FALSE, na.strings = character())
  Python  pandas.read_csv("v.csv", comment="#", keep_default_na=False, na_values=[""])
Without the arguments about "NA" both take a stimulus of that name for a missing value.)";

std::string rendered(const ExportRequest& request, const ExportedMatrix& exported) {
  switch (request.format) {
    case ExportFormat::Csv:
      return matrix_table_csv(
          exported,
          request.proportions ? CellContent::RowProportions : CellContent::Counts,
          !request.bare);
    case ExportFormat::Long:
      return matrix_list_csv(exported, !request.bare);
    case ExportFormat::Json:
      return matrix_json(exported);
    case ExportFormat::Praat:
      return matrix_praat(exported);
    case ExportFormat::Latex:
      return matrix_latex(exported);
    case ExportFormat::Markdown:
      return matrix_markdown(exported);
  }
  return {};
}

ExitCode export_matrix(const ExportRequest& request, Console console) {
  const auto chosen = load_chosen(request.choice, console);
  if (!chosen) return ExitCode::Findings;
  const auto& title = request.title.empty() ? chosen->title : request.title;
  ExportedMatrix exported{title, chosen->warnings, chosen->matrix, request.order};
  exported.provenance = chosen->provenance;
  const auto text = rendered(request, exported);
  if (request.file.empty()) {
    console.out << text << std::flush;
  } else {
    write_file(request.file, text);
    console.out << request.file.string() << std::endl;
  }
  for (const auto& warning : chosen->warnings) console.err << "warning: " << warning << '\n';
  return ExitCode::Done;
}

/// For options that mean something for some formats only.
void require_format(const ExportRequest& request) {
  const bool csv = request.format == ExportFormat::Csv;
  if (request.proportions && !csv) {
    throw CLI::ValidationError{"--proportions",
                               "is for --format csv; praat has counts, the others have both"};
  }
  if (request.bare && !csv && request.format != ExportFormat::Long) {
    throw CLI::ValidationError{"--bare", "is for --format csv and long"};
  }
}

void add_export_options(CLI::App& verb, ExportRequest& request) {
  add_choice<ExportFormat>(verb,
                           "--format",
                           request.format,
                           {{"csv", ExportFormat::Csv},
                            {"long", ExportFormat::Long},
                            {"json", ExportFormat::Json},
                            {"praat", ExportFormat::Praat},
                            {"latex", ExportFormat::Latex},
                            {"markdown", ExportFormat::Markdown}},
                           "What to write")
      ->required();
  add_choice<LabelOrder>(verb,
                         "--order",
                         request.order,
                         {{"given", LabelOrder::Given},
                          {"place", LabelOrder::Place},
                          {"clusters", LabelOrder::Clusters}},
                         "Of rows and columns: given (default), place (of articulation, of "
                         "ARPAbet), or clusters (as a dendrogram draws them)");
  verb.add_flag("--proportions", request.proportions, "Row proportions instead of counts (csv)");
  verb.add_flag("--bare", request.bare, "Without the lines before the header (csv, long)");
  verb.add_option("--title", request.title, "What the matrix is called there");
  const auto folder_is_there = [](const std::string& file) -> std::string {
    const auto folder = std::filesystem::absolute(file).parent_path();
    if (std::filesystem::is_directory(folder)) return {};
    return fmt::format("there is no folder {}; make it first", folder.string());
  };
  verb.add_option("-o,--output", request.file, "File to write; else it is printed")
      ->check(CLI::Validator{folder_is_there, ""});
}

}  // namespace

void add_export_verb(CLI::App& program, Verb& chosen) {
  const auto request = std::make_shared<ExportRequest>();
  auto* const verb = program.add_subcommand(
      "export", "Write one confusion matrix for other programs, or as a table of a paper");
  verb->footer(kExamples);
  add_matrix_options(*verb, request->choice);
  add_export_options(*verb, *request);
  add_idle_resampling(*verb);
  verb->callback([request, &chosen] {
    require_format(*request);
    chosen = [request](Console console) { return export_matrix(*request, console); };
  });
}

}  // namespace bimodal::analysis
