#include <chrono>
#include <memory>
#include <system_error>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/cli/command_line.hpp"
#include "analysis/cli/verb.hpp"
#include "analysis/report/attachment.hpp"
#include "analysis/report/figure_files.hpp"
#include "analysis/report/page.hpp"
#include "analysis/report/print/report_pdf.hpp"
#include "analysis/report/tables.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::analysis {

namespace {

struct ReportRequest {
  AnalysisRequest analysis;
  FaceConditions faces;  ///< both empty: none are compared
  std::string command;   ///< as typed
  std::filesystem::path folder;
  std::vector<std::string> pictures;
  std::vector<std::string> sounds;
};

constexpr const char* kExamples = R"(Examples:
  bimodal-analysis report session.sqlite -o report
  bimodal-analysis report P*.sqlite -o report --exclude-flagged --draws 10000
  bimodal-analysis report s.sqlite -o report --condition visual --participant P01
  bimodal-analysis report P*.sqlite -o report --natural V_nat --synthetic V_syn
  bimodal-analysis report s.sqlite -o report \
      --attach-picture 'trial.png:Trial 12, mid-word' --attach-sound 'trial.wav:Trial 12'

Writes report.html (one file, no network needed), the same as report.pdf, every figure
as SVG and PDF in figures/ (85 and 174 mm wide), trials.csv, words.csv, proportions.csv,
benefits.csv, confusions.csv, likeness.csv, comparison.csv and contrasts.csv (of the two
faces named), exclusions.csv, columns.csv (what every column means) and manifest.json
into the folder; prints the page's path last.)";

std::string selection_in_words(const Selection& selection) {
  std::string words =
      selection.include_practice ? "practice trials included" : "without practice trials";
  words += selection.exclude_flagged ? ", without flagged trials" : ", flagged trials included";
  if (selection.exclude_simulated) words += ", without simulated answers";
  if (!selection.conditions.empty()) {
    words += fmt::format(", conditions {} only", fmt::join(selection.conditions, ", "));
  }
  if (!selection.participants.empty()) {
    words += fmt::format(", participants {} only", fmt::join(selection.participants, ", "));
  }
  return words;
}

std::string now_utc() {
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", now);
}

std::vector<Attachment> read_attachments(const ReportRequest& request) {
  std::vector<Attachment> attachments;
  for (const auto& picture : request.pictures) {
    attachments.push_back(read_attachment(Attachment::Kind::Picture, picture));
  }
  for (const auto& sound : request.sounds) {
    attachments.push_back(read_attachment(Attachment::Kind::Sound, sound));
  }
  return attachments;
}

void add_face_options(CLI::App& verb, ReportRequest& request) {
  auto* const natural = verb.add_option(
      "--natural", request.faces.natural, "Condition with the natural face, to be compared");
  auto* const synthetic =
      verb.add_option("--synthetic", request.faces.synthetic, "Condition with the synthetic face");
  natural->needs(synthetic);
  synthetic->needs(natural);
  verb.add_option_function<int>(
          "--resamples,--draws",
          [&request](int resamples) {
            request.analysis.bootstrap.draws = resamples;
            request.analysis.comparison.permutations = resamples;
          },
          "Bootstrap draws, and permutations [2000 and 10000]")
      ->check(CLI::Range(100, 1'000'000));
}

AnalysisRequest analysis_of(const ReportRequest& request) {
  auto analysis = request.analysis;
  analysis.comparison.seed = analysis.bootstrap.seed;
  if (!request.faces.natural.empty()) analysis.faces = request.faces;
  return analysis;
}

ExitCode make_report(const ReportRequest& request, Console console) {
  const auto attachments = read_attachments(request);
  const auto results = analyse_request(analysis_of(request), console);
  if (results.dataset.trials.empty()) {
    console.err << "bimodal-analysis: " << nothing_left(results.dataset) << '\n';
    return ExitCode::Findings;
  }
  const Making making{.program = program_name(),
                      .made_utc = now_utc(),
                      .selection = selection_in_words(request.analysis.selection),
                      .command = request.command};
  std::error_code failure;
  std::filesystem::create_directories(request.folder / "figures", failure);
  if (failure) {
    throw Error{
        fmt::format("writing the report: cannot make the folder '{}': {}; choose another "
                    "with -o",
                    request.folder.string(),
                    failure.message())};
  }
  for (const auto& file : report_tables(results, making)) {
    write_file(request.folder / file.name, file.content);
  }
  for (const auto& file : figure_files(results, making)) {
    write_file(request.folder / file.name, file.content);
  }
  const auto page = request.folder / "report.html";
  const auto content = report_page(results, attachments, making);
  write_file(page, content);
  write_file(request.folder / "report.pdf", report_pdf(content, making.made_utc));
  for (const auto& warning : results.warnings) console.err << "warning: " << warning << '\n';
  console.out << page.string() << std::endl;
  return ExitCode::Done;
}

}  // namespace

void add_report_verb(CLI::App& program, Verb& chosen, std::span<const std::string> arguments) {
  const auto request = std::make_shared<ReportRequest>();
  request->command = command_line("bimodal-analysis", arguments);
  auto* const verb = program.add_subcommand(
      "report", "Scores, intervals and confusion matrices as one HTML page and tidy CSV tables");
  verb->footer(kExamples);
  add_analysis_options(*verb, request->analysis);
  verb->add_option("-o,--output", request->folder, "Folder to write into; made if need be")
      ->required();
  verb->add_option("--condition",
                   request->analysis.selection.conditions,
                   "Only this condition (may be repeated)")
      ->allow_extra_args(false);
  add_face_options(*verb, *request);
  add_seed_option(*verb, request->analysis.bootstrap.seed);
  verb->add_option("--attach-picture", request->pictures, "PNG or JPEG as FILE:caption")
      ->allow_extra_args(false);
  verb->add_option("--attach-sound", request->sounds, "WAV or FLAC as FILE:caption")
      ->allow_extra_args(false);
  verb->callback([request, &chosen] {
    chosen = [request](Console console) { return make_report(*request, console); };
  });
}

}  // namespace bimodal::analysis
