#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "runner/cli/expression_list.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/cli/seen_speech.hpp"
#include "runner/cli/spoken_score.hpp"
#include "runner/cli/text_table.hpp"
#include "runner/cli/verbs.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/figures/figure.hpp"
#include "synth/inspection/mouth_columns.hpp"

namespace bimodal::runner {

namespace {

struct MeasuresOptions {
  SpokenOptions spoken;
  std::string account = "dominance";
  std::vector<std::string> expressions;
  double rate_hz = 60;
  std::string output;
  bool list = false;
};

/// The mouth over time, one row per column of mouth_columns().
struct Measured {
  std::vector<double> time_ms;
  std::vector<std::vector<double>> values;
};

Measured measured(const SeenSpeech& seen, double rate_hz) {
  const auto columns = synth::mouth_columns();
  const auto pictures =
      static_cast<std::size_t>(std::ceil(seen.end.count() * rate_hz / 1000 - 1e-9));
  constexpr std::size_t kMostPictures = 1'000'000;
  if (pictures > kMostPictures) {
    throw Error{fmt::format("{} pictures are more than {}; lower --rate-hz or shorten the text",
                            pictures,
                            kMostPictures)};
  }
  const synth::Head head{asset("synth/assets/head")};
  synth::MouthRuler ruler{head};
  Measured result;
  result.values.resize(columns.size());
  const bool is_told = isatty(STDERR_FILENO) == 1;
  for (std::size_t i = 0; i < pictures; ++i) {
    if (is_told && i % 30 == 0) fmt::print(stderr, "\rpicture {} of {} ", i + 1, pictures);
    const double time_ms = 1000.0 * static_cast<double>(i) / rate_hz;
    const auto measures = ruler.measure(seen.pose(Milliseconds{time_ms}));
    result.time_ms.push_back(time_ms);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      result.values[c].push_back(columns[c].of(measures));
    }
  }
  if (is_told) fmt::print(stderr, "\r{:40}\r", "");
  return result;
}

std::string csv_of(const Measured& measured) {
  std::string text = "time_ms";
  for (const auto& column : synth::mouth_columns()) text += fmt::format(",{}", column.name);
  text += '\n';
  for (std::size_t i = 0; i < measured.time_ms.size(); ++i) {
    text += fmt::format("{:.4f}", measured.time_ms[i]);
    for (const auto& values : measured.values) text += fmt::format(",{:.4f}", values[i]);
    text += '\n';
  }
  return text;
}

std::string json_of(const Measured& measured, const MeasuresOptions& options) {
  nlohmann::ordered_json tree;
  tree["text"] = options.spoken.text;
  tree["rate_hz"] = options.rate_hz;
  tree["time_ms"] = measured.time_ms;
  const auto columns = synth::mouth_columns();
  for (std::size_t c = 0; c < columns.size(); ++c) {
    tree["measures"][std::string{columns[c].name}] = measured.values[c];
  }
  return tree.dump(1) + "\n";
}

/// A panel for each measure that changes, phones named at the top.
Figure figure_of(const Measured& measured, const SeenSpeech& seen, const std::string& title) {
  Figure figure{.title = title,
                .caption = "Measured on the drawn mesh; areas as seen from straight ahead.",
                .panels = {},
                .columns = 2};
  constexpr double kPanelHeight = 150;
  figure.panel_height = kPanelHeight;
  const auto columns = synth::mouth_columns();
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto [least, most] = std::ranges::minmax(measured.values[c]);
    if (most - least < 1e-6) continue;
    Panel panel;
    panel.title = std::string{columns[c].meaning};
    panel.y_label = std::string{columns[c].name};
    panel.x_label = "time (ms)";
    panel.x_range = {0, seen.end.count()};
    Curve curve;
    for (std::size_t i = 0; i < measured.time_ms.size(); ++i) {
      curve.points.push_back({measured.time_ms[i], measured.values[c][i]});
    }
    panel.curves.push_back(std::move(curve));
    for (const auto& centre : seen.centres) {
      panel.lines.push_back({.x = centre.time.count(), .label = centre.symbol});
    }
    figure.panels.push_back(std::move(panel));
  }
  if (figure.panels.empty()) throw Error{"nothing of the mouth moves; there is nothing to plot"};
  return figure;
}

ExitCode list_columns() {
  std::vector<std::vector<std::string>> rows{{"column", "meaning"}};
  for (const auto& column : synth::mouth_columns()) {
    rows.push_back({std::string{column.name}, std::string{column.meaning}});
  }
  print_text_table(rows, "ll");
  return ExitCode::Done;
}

ExitCode measures(const MeasuresOptions& options) {
  if (options.list) return list_columns();
  const auto ending = std::filesystem::path{options.output}.extension().string();
  const bool is_figure = ending == ".svg" || ending == ".pdf" || ending == ".png";
  if (!options.output.empty() && !is_figure && ending != ".csv" && ending != ".json") {
    throw Error{fmt::format(
        "'{}': measures are written as .csv, .json, .svg, .pdf or .png; end the name so",
        options.output)};
  }
  const auto seen =
      names_tracks(options.spoken.text)
          ? tracked_speech(options.spoken.text)
          : articulated_speech(options.spoken, account_from_name(options.account).value(), false);
  const auto table = measured(seen, options.rate_hz);
  if (is_figure) {
    write_figure(figure_of(table, seen, options.spoken.text), options.output);
  } else {
    const auto text = ending == ".json" ? json_of(table, options) : csv_of(table);
    if (options.output.empty()) {
      fmt::print("{}", text);
      return ExitCode::Done;
    }
    write_file(options.output, text);
  }
  fmt::print("{}: {} measures in {} pictures\n",
             options.output,
             table.values.size(),
             table.time_ms.size());
  return ExitCode::Done;
}

}  // namespace

void add_measures(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "measures",
      "Measures the mouth of the drawn face in every picture while it says a text, a "
      "transcription\n"
      "or a score, or does what tracks say: lips, jaw, visible teeth and tongue, and where the\n"
      "tongue touches.\n"
      "Exit code: 0 done, 3 errors.\n\n"
      "Examples:\n"
      "  bimodal measures stew > stew.csv                 each 1/60 s\n"
      "  bimodal measures --from arpabet \"AA F AA\" -o afa.svg\n"
      "  bimodal measures tracks.csv --rate-hz 200 -o mine.json\n"
      "  bimodal measures --list                          every column and its meaning");
  auto options = std::make_shared<MeasuresOptions>();
  add_spoken_options(*verb, options->spoken);
  auto* const text = verb->get_option("SCORE|TEXT")->required(false);
  add_account_option(*verb, options->account);
  add_expression_option(*verb, options->expressions);
  verb->add_option("--rate-hz", options->rate_hz, "pictures a second (60)")
      ->check(finite_number())
      ->check(CLI::Range(1.0, 10'000.0));
  verb->add_option("-o,--output", options->output, "file (.csv, .json, .svg, .pdf, .png)")
      ->check(in_a_folder_that_exists());
  auto* const list = verb->add_flag("--list", options->list, "prints all columns");
  verb->callback([options, text, list, &chosen] {
    if (text->count() == 0 && list->count() == 0) throw CLI::RequiredError("SCORE|TEXT or --list");
    chosen = [options] { return measures(*options); };
  });
}

}  // namespace bimodal::runner
