#include "synth/speech/tracks.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "runner/cli/option_checks.hpp"
#include "runner/cli/spoken_score.hpp"
#include "runner/cli/verbs.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"
#include "synth/figures/track_figure.hpp"

namespace bimodal::runner {

namespace {

struct TracksOptions {
  SpokenOptions spoken;
  double rate_hz = 1000;
  bool csv = false;
  bool json = false;
  bool svg = false;
  bool dominance = false;
  std::string account = "dominance";
  std::vector<std::string> controls;
  std::string output;
};

/// "csv", "json", "svg", "pdf" or "png": as a flag says, or the name of the output ends.
std::string form_of(const TracksOptions& options) {
  constexpr std::array kForms{".csv", ".json", ".svg", ".pdf", ".png"};
  const auto ending = std::filesystem::path{options.output}.extension().string();
  const bool is_known = std::ranges::find(kForms, ending) != kForms.end();
  for (const auto& [is_asked, form] :
       {std::pair{options.json, ".json"}, {options.svg, ".svg"}, {options.csv, ".csv"}}) {
    if (!is_asked) continue;
    if (is_known && ending != form) {
      throw Error{
          fmt::format("'{}' is not the name of a file of the form --{}; end it with {}, or "
                      "leave the option out",
                      options.output,
                      form + 1,
                      form)};
    }
    return form + 1;
  }
  if (options.output.empty()) return "csv";
  if (is_known) return ending.substr(1);
  throw Error{fmt::format(
      "'{}': tracks are written as .csv, .json, .svg, .pdf or .png; end the name so, or say which "
      "by --csv, --json or --svg",
      options.output)};
}

/// What the plot itself does not show.
std::string caption_of(const TracksOptions& options) {
  auto caption = fmt::format("Account: {}. Inventory: {}. Rate: {:g}.",
                             options.account,
                             options.spoken.segments,
                             options.spoken.rate);
  if (options.dominance && options.account != "dominance") {
    caption +=
        " The dominances are those of the account \"dominance\"; this one does not weigh by them.";
  }
  return caption;
}

ExitCode tracks(const TracksOptions& options) {
  const auto form = form_of(options);
  const auto score = spoken_score(options.spoken);
  const auto claims = synth::claims_of(score, chosen_segments(options.spoken));
  const auto sampled = synth::sample(claims,
                                     {.rate = Hertz{options.rate_hz},
                                      .account = account_from_name(options.account).value(),
                                      .controls = options.controls,
                                      .with_dominance = options.dominance});
  const auto figure = [&] {
    auto drawn = synth::figure_of(sampled, options.spoken.text);
    drawn.caption = caption_of(options);
    return drawn;
  };
  if (form == "pdf" || form == "png") {
    write_figure(figure(), options.output);
  } else {
    const auto text = form == "json"  ? synth::json_of(sampled)
                      : form == "svg" ? svg_of(figure())
                                      : synth::csv_of(sampled);
    if (options.output.empty()) {
      fmt::print("{}", text);
      return ExitCode::Done;
    }
    write_file(options.output, text);
  }
  fmt::print("{}: {} controls at {} instants, {} segments\n",
             options.output,
             sampled.controls.size(),
             sampled.time_ms.size(),
             sampled.segments.size());
  return ExitCode::Done;
}

}  // namespace

void add_tracks(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "tracks",
      "Tells how each control of the face moves for a text, a transcription or a score of your\n"
      "own (JSON; its form: synth/speech/README.md), as a table or a plot.\n"
      "Exit code: 0 done, 3 errors.\n\n"
      "Examples:\n"
      "  bimodal tracks stew > stew.csv                      every control, each ms\n"
      "  bimodal tracks stew --controls lip_protrusion --dominance -o stew.svg\n"
      "  bimodal tracks --from arpabet \"S:140 T:60 UW1:200\" --rate-hz 60\n"
      "  bimodal tracks --from arpabet \"UW T UW\" --rate 0.5 --account look-ahead -o utu.png\n"
      "  bimodal tracks --from arpabet \"b~w:3/8 AA\" -o half.csv   an ambiguous sound\n"
      "  bimodal tracks score.json --dominance               p, and p@0, p@1 ... of each segment");
  auto options = std::make_shared<TracksOptions>();
  add_spoken_options(*verb, options->spoken);
  verb->add_option("--rate-hz", options->rate_hz, "instants a second (1000)")
      ->check(finite_number())
      ->check(CLI::Range(1e-3, 1e6));
  auto* const csv = verb->add_flag("--csv", options->csv, "a table (default)");
  auto* const json = verb->add_flag("--json", options->json, "with the segments and their claims");
  auto* const svg = verb->add_flag("--svg", options->svg, "a plot");
  csv->excludes(json)->excludes(svg);
  json->excludes(svg);
  verb->add_flag("--dominance", options->dominance, "also the dominance of each segment");
  verb->add_option("--controls", options->controls, "only these, e.g. jaw,lip_width")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_account_option(*verb, options->account);
  verb->add_option("-o,--output", options->output, "file (.csv, .json, .svg, .pdf, .png)")
      ->check(in_a_folder_that_exists());
  verb->callback([options, &chosen] { chosen = [options] { return tracks(*options); }; });
}

}  // namespace bimodal::runner
