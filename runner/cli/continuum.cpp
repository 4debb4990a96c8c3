#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "runner/cli/continuum_files.hpp"
#include "runner/cli/continuum_plots.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/cli/spoken_score.hpp"
#include "runner/cli/text_table.hpp"
#include "runner/cli/verbs.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/timeline/inventory_file.hpp"

namespace bimodal::runner {

namespace {

struct ContinuumOptions {
  std::vector<std::string> ends;
  std::size_t steps = 9;
  std::string context = "_ AA";
  std::vector<std::string> varied;
  std::optional<double> low;
  std::optional<double> high;
  std::string output;
  std::string segments = "english";
  std::string account = "dominance";
  ViewOptions view;
  double rate_hz = 60;
  std::string format = "svg";
  bool without_videos = false;
};

Segment sound(const std::string& typed) {
  const auto parsed = parse_segment(typed);
  if (const auto* fault = std::get_if<SegmentFault>(&parsed)) {
    throw Error{fmt::format("{}; {}", fault->finding, fault->remedy)};
  }
  const auto& segment = std::get<Segment>(parsed);
  if (segment.is_ambiguous()) {
    throw Error{fmt::format("\"{}\" lies between two sounds itself; give plain ones", typed)};
  }
  return segment;
}

synth::ContinuumDesign design_of(const ContinuumOptions& options) {
  if (options.ends.size() == 2 && !options.varied.empty()) {
    throw Error{"two sounds and --vary; give one sound and --vary, or two sounds without it"};
  }
  if (options.ends.size() == 1 && options.varied.empty()) {
    throw Error{"one sound alone is no continuum; give a second one, or --vary CONTROL"};
  }
  if (options.ends.size() == 2 && (options.low || options.high)) {
    throw Error{"--low and --high are values of --vary; leave them out between two sounds"};
  }
  synth::ContinuumDesign design{.from = sound(options.ends.front()),
                                .to = {},
                                .varied = {},
                                .low = options.low.value_or(0),
                                .high = options.high.value_or(1),
                                .steps = options.steps,
                                .context = options.context};
  if (options.ends.size() == 2) design.to = sound(options.ends.back());
  for (const auto& text : options.varied) design.varied.push_back(synth::parse_varied(text));
  return design;
}

/// Values of varied targets that the face cannot show.
void tell_limits(const synth::ContinuumDesign& design) {
  for (const auto& [control, parameter] : design.varied) {
    if (parameter != synth::Varied::Target) continue;
    const auto& range = synth::describe(control);
    const auto [low, high] = std::minmax(design.low, design.high);
    if (low >= range.lowest && high <= range.highest) continue;
    fmt::print(stderr,
               "note: {} goes from {} to {}; targets beyond only hold the face longer at its "
               "limit\n",
               range.name,
               range.lowest,
               range.highest);
  }
}

void print_tokens(const synth::Continuum& continuum) {
  std::vector<std::vector<std::string>> rows{
      {"token", "sound", "opening mm", "width mm", "shut ms", "half open ms", "fastest mm/s"}};
  for (std::size_t i = 0; i < continuum.tokens.size(); ++i) {
    const auto& [pose, released, lips, shut, half_open, fastest] = continuum.middles[i];
    rows.push_back({synth::token_name(continuum, i),
                    continuum.tokens[i].name,
                    fmt::format("{:.2f}", lips.inner_height_mm),
                    fmt::format("{:.1f}", lips.outer_width_mm),
                    fmt::format("{:.0f}", shut.count()),
                    half_open ? fmt::format("{:.0f}", half_open->count()) : "-",
                    fmt::format("{:.0f}", fastest)});
  }
  print_text_table(rows, "llrrrrr");
}

ExitCode continuum(const ContinuumOptions& options) {
  const auto design = design_of(options);
  const synth::SegmentTable table{inventory_file(options.segments)};
  const synth::Head head{asset("synth/assets/head")};
  const auto made = synth::worked_out(
      synth::tokens_of(design, table), table, account_from_name(options.account).value(), head);
  const std::filesystem::path folder{options.output};
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault) {
    throw Error{fmt::format("cannot make the folder '{}': {}", options.output, fault.message())};
  }
  const auto title =
      design.to ? fmt::format(
                      "{} to {} in \"{}\"", symbol(design.from), symbol(*design.to), design.context)
                : fmt::format("{} in \"{}\": {} from {} to {}",
                              symbol(design.from),
                              design.context,
                              fmt::join(options.varied, ", "),
                              design.low,
                              design.high);
  remove_earlier_tokens(folder);
  write_token_table(made, folder);
  const bool has_words = design.to && write_token_words(made, folder);
  write_token_tracks(made, folder);
  write_token_plots(made, title, options.format, folder);
  write_token_strip(made, head, options.view, folder);
  if (!options.without_videos) {
    write_token_videos(made, head, options.view, frame_rate_near(Hertz{options.rate_hz}), folder);
  }
  print_tokens(made);
  tell_limits(design);
  for (const auto& caution : synth::cautions(made)) fmt::print(stderr, "note: {}\n", caution);
  fmt::print("\n{}: {} with tracks{}; tokens.csv,{} controls.{}, movements.{}, strip.png\n",
             options.output,
             counted(made.tokens.size(), "token"),
             options.without_videos ? "" : " and videos",
             has_words ? " tokens.json (a word list for protocols)," : "",
             options.format,
             options.format);
  return ExitCode::Done;
}

}  // namespace

void add_continuum(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "continuum",
      "Makes tokens from one sound to another, the parameters of the segment in even steps (but\n"
      "for contacts: synth/speech/README.md); or along controls or dynamics of one sound. Writes "
      "for each token the movement\n"
      "of every control (CSV) and a video, and for all a table, plots over the steps and over\n"
      "time, and a strip of pictures of middles and releases; and, between two sounds, "
      "tokens.json, "
      "a word "
      "list\n"
      "that protocols take. What an earlier continuum left in the folder is removed. In protocols, "
      "scores and elsewhere a token is called as here, e.g. B~W:3/8.\n"
      "Exit code: 0 done, 3 errors.\n\n"
      "Examples:\n"
      "  bimodal continuum b w --steps 9 --in \"_ AA\" -o bw\n"
      "  bimodal continuum iy uw --steps 5 --in \"B _ B\" --view mouth -o iu\n"
      "  bimodal continuum b --vary cheek_puff --low 0 --high 1 --steps 5 -o puffed\n"
      "  bimodal continuum b --vary lip_closure.theta_after,lip_compression.theta_after \\\n"
      "      --low 0.025 --high 0.08 --in \"AA _ AA\" -o speed     speed of opening");
  auto options = std::make_shared<ContinuumOptions>();
  verb->add_option("SOUNDS", options->ends, "both ends, e.g. b w; or one, with --vary")
      ->required()
      ->expected(1, 2);
  verb->add_option("--steps", options->steps, "number of tokens, both ends included (9)")
      ->check(CLI::Range(2, kMostSteps));
  verb->add_option(
      "--in",
      options->context,
      "context in ARPAbet with \"_\" for the sound, e.g. \"_ AA\" (default); durations "
      "in ms where wanted: \"AA:150 _:90 AA:200\"");
  verb->add_option("--vary",
                   options->varied,
                   "controls, or their alpha, theta_before, theta_after or offset_ms, e.g. "
                   "cheek_puff, lip_closure.theta_after")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb->add_option("--low", options->low, "value of --vary in the first token (0)")
      ->check(finite_number());
  verb->add_option("--high", options->high, "value of --vary in the last token (1)")
      ->check(finite_number());
  verb->add_option("-o,--output", options->output, "folder, made if it is not there")->required();
  verb->add_option("--segments", options->segments, "inventory: a file, or english (default)");
  add_account_option(*verb, options->account);
  add_view_options(*verb, options->view);
  verb->add_option("--rate-hz", options->rate_hz, "frames a second of the videos (60)")
      ->check(CLI::Range(1, 1000));
  verb->add_option("--format", options->format, "of the plots: svg (default), pdf or png")
      ->check(CLI::IsMember({"svg", "pdf", "png"}));
  verb->add_flag("--no-video", options->without_videos, "no videos, which take longest");
  verb->callback([options, &chosen] { chosen = [options] { return continuum(*options); }; });
}

}  // namespace bimodal::runner
