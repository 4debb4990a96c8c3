#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "runner/cli/fit_tables.hpp"
#include "runner/cli/labelled_track.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/cli/verbs.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"
#include "synth/fitting/definitions.hpp"
#include "synth/fitting/leave_one_out.hpp"

namespace bimodal::runner {

namespace {

using synth::MeasuredClip;
using synth::MeasureKind;
using synth::ThetaSharing;

struct FitSegmentsOptions {
  std::vector<std::string> tracks;
  std::vector<std::string> labels;
  std::vector<std::string> columns;
  std::vector<std::string> openings;
  std::string time_column;
  std::string theta = "best";
  double shrinkage = -1;  ///< below 0: chosen
  bool leave_one_out = false;
  bool same_talker = false;
  std::string output;
};

constexpr double kLeastCoverage = 0.8;

/// A theta in 1/ms; absent if it is none.
std::optional<double> theta_value(const std::string& text) {
  double value = 0;
  const auto* const end = text.data() + text.size();
  const auto [stopped, fault] = std::from_chars(text.data(), end, value);
  if (fault != std::errc{} || stopped != end || !(value > 0 && value <= 1)) return std::nullopt;
  return value;
}

struct Sharing {
  std::string_view name;
  ThetaSharing theta;
};

constexpr std::array<Sharing, 5> kSharings{{{"best", ThetaSharing::One},
                                            {"one", ThetaSharing::One},
                                            {"sides", ThetaSharing::Sides},
                                            {"class", ThetaSharing::Class},
                                            {"class-sides", ThetaSharing::ClassAndSide}}};

/// Absent if it is none of the names.
std::optional<ThetaSharing> sharing_named(std::string_view name) {
  const auto* const found = std::ranges::find(kSharings, name, &Sharing::name);
  if (found == kSharings.end()) return std::nullopt;
  return found->theta;
}

CLI::Validator theta_check() {
  return {[](std::string& text) -> std::string {
            if (sharing_named(text) || theta_value(text)) return {};
            return fmt::format(
                "\"{}\" is no theta; give best, one, sides, class, class-sides, or a number in "
                "1/ms, e.g. 0.022",
                text);
          },
          ""};
}

MeasureKind kind_of(const std::string& column, const FitSegmentsOptions& options) {
  if (options.openings.empty()) return synth::kind_of(column);
  const bool opens = std::ranges::find(options.openings, column) != options.openings.end();
  return opens ? MeasureKind::Opening : MeasureKind::Position;
}

synth::FitOptions fit_options(const std::string& column, const FitSegmentsOptions& options) {
  synth::FitOptions how{.kind = kind_of(column, options), .own_talkers = !options.same_talker};
  how.theta_per_ms = theta_value(options.theta);
  how.theta = sharing_named(options.theta).value_or(ThetaSharing::One);
  if (options.shrinkage >= 0) how.shrinkage = options.shrinkage;
  return how;
}

/// All recordings, after every one of them was judged.
std::vector<LabelledTrack> read_recordings(const FitSegmentsOptions& options) {
  const auto labels = labels_of_tracks(options.tracks, options.labels);
  std::vector<LabelledTrack> recordings;
  std::string mistakes;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    try {
      recordings.push_back(read_labelled_track(
          options.tracks[i],
          labels[i],
          {.time_column = options.time_column,
           .columns = i == 0 || !options.columns.empty() ? options.columns
                                                         : column_names(recordings.front())}));
    } catch (const Error& error) {
      mistakes += (mistakes.empty() ? "" : "\n") + std::string{error.what()};
      if (recordings.empty() && options.columns.empty()) break;
    }
  }
  if (!mistakes.empty()) throw Error{mistakes};
  return recordings;
}

std::vector<MeasuredClip> clips_of(const std::vector<LabelledTrack>& recordings,
                                   const std::string& column,
                                   const synth::FitOptions& how) {
  const bool relative = how.kind == MeasureKind::Position && how.own_talkers;
  std::vector<MeasuredClip> clips;
  for (const auto& [name, track, labels, utterance] : recordings) {
    clips.push_back(
        synth::measured_clip(name, track, *track.column(column), utterance, labels, relative));
  }
  return clips;
}

/// Options that were chosen by leaving clips out, and how well these are told then.
synth::Chosen chosen_for(const std::string& column,
                         const std::vector<MeasuredClip>& clips,
                         const FitSegmentsOptions& options) {
  const auto how = fit_options(column, options);
  if (!options.leave_one_out) return {.options = how, .left_out = {}};
  synth::Choice choice;
  if (options.theta != "best") choice.thetas_per_ms.clear();
  if (options.shrinkage >= 0) choice.shrinkages.clear();
  const bool to_terminal = isatty(STDERR_FILENO) == 1;
  std::size_t trials = 0;
  const auto tell = [&](const synth::Chosen& tried) {
    ++trials;
    if (!to_terminal) return;
    fmt::print(stderr,
               "\r{}: trial {}, left-out r {:.3f} ",
               column,
               trials,
               over_clips(tried.left_out).r.value_or(0));
    std::fflush(stderr);
  };
  auto chosen = synth::choose(clips, how, choice, tell);
  if (to_terminal) fmt::print(stderr, "\r{:60}\r", "");
  return chosen;
}

std::string about_measure(const FitReport& report) {
  const auto what =
      report.relative ? "relative to the talker's mean over the speech" : "as measured";
  return fmt::format("{}: {}; {}", report.column, what, summary(report));
}

void write_definitions(const std::vector<FitReport>& reports, const FitSegmentsOptions& options) {
  std::vector<synth::FittedMeasure> measures;
  std::vector<std::string> about{
      fmt::format("Fitted by bimodal {} fit-segments to {}: dominance alpha exp(-theta |distance "
                  "in ms from centre + offset_ms|), Cohen & Massaro (1993), equations 1 to 6.",
                  BIMODAL_VERSION,
                  counted(options.tracks.size(), "clip"))};
  for (const auto& report : reports) {
    measures.push_back({.name = report.column, .fit = report.fit});
    about.push_back(about_measure(report));
  }
  write_file(options.output, synth::definitions_json(measures, about));
}

/// How many warnings there were.
std::size_t warn(const std::vector<FitReport>& reports) {
  std::size_t warnings = 0;
  const auto say = [&](const std::string& text) {
    fmt::print(stderr, "bimodal: warning: {}\n", text);
    ++warnings;
  };
  for (const auto& clip : reports.front().clips) {
    if (coverage(clip) >= kLeastCoverage) continue;
    say(fmt::format("the track of {} covers {:.0f} % of its speech and 100 ms around it",
                    clip.name,
                    100 * coverage(clip)));
  }
  for (const auto& report : reports) {
    if (report.fit.converged) continue;
    say(
        fmt::format("{}: the fit has not settled after {} steps; give fewer thetas, or a greater "
                    "--shrinkage",
                    report.column,
                    report.fit.steps));
  }
  std::vector<std::string_view> single;
  const auto& tokens = reports.front().fit.tokens;
  for (std::size_t part = 0; part < tokens.size(); ++part) {
    if (tokens[part] == 1) single.push_back(synth::parts()[part].name);
  }
  if (!single.empty()) {
    say(
        fmt::format("of {} there is one token; their numbers are little more than those of their "
                    "class; record them more often",
                    fmt::join(single, ", ")));
  }
  return warnings;
}

ExitCode fit_segments(FitSegmentsOptions options) {
  options.tracks = without_folders(options.tracks, options.labels);
  if (options.leave_one_out && options.tracks.size() < 3) {
    throw Error{
        fmt::format("--leave-one-out needs three clips or more, and here are {}; leave it "
                    "out, or give more clips",
                    options.tracks.size())};
  }
  const auto recordings = read_recordings(options);
  const auto columns = column_names(recordings.front());
  for (const auto& opening : options.openings) {
    if (std::ranges::find(columns, opening) != columns.end()) continue;
    throw Error{fmt::format(
        "--openings: \"{}\" is not fitted; there are {}", opening, fmt::join(columns, ", "))};
  }
  std::vector<FitReport> reports;
  for (const auto& column : columns) {
    auto clips = clips_of(recordings, column, fit_options(column, options));
    auto chosen = chosen_for(column, clips, options);
    auto found = synth::fit(clips, chosen.options);
    reports.push_back(report_of(column, std::move(clips), std::move(chosen), std::move(found)));
    print_fit(reports.back());
  }
  if (!options.output.empty()) {
    write_definitions(reports, options);
    fmt::print("{}: {} written\n", options.output, counted(columns.size(), "measure"));
  }
  return warn(reports) == 0 ? ExitCode::Done : ExitCode::Findings;
}

}  // namespace

void add_fit_segments(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "fit-segments",
      "Learns from measured tracks what each speech segment asks of a measure of the face: "
      "target,\n"
      "alpha, theta and t_o of the dominance model, by least squares. TRACKS are tables with "
      "times\n"
      "(time_ms or time_s) and measures; labels say which phone sounds when. Numbers that few\n"
      "tokens speak for are pulled to those of their class. --leave-one-out says how well the fit\n"
      "tells clips that it has not seen, and chooses theta and the strength of the pull by that.\n"
      "Exit code: 0 done, 1 warnings, 3 errors.\n\n"
      "Examples:\n"
      "  bimodal fit-segments anna.csv --labels anna.TextGrid\n"
      "  bimodal fit-segments lips --labels lips --columns inner_h,outer_w --leave-one-out\n"
      "  bimodal fit-segments a1.csv a2.csv --labels a1.TextGrid a2.TextGrid --same-talker \\\n"
      "      --theta 0.022 -o anna.json");
  auto options = std::make_shared<FitSegmentsOptions>();
  verb->add_option("TRACKS",
                   options->tracks,
                   "tables of measures, one a recording; a folder: those in it that have labels")
      ->required();
  verb->add_option("--labels",
                   options->labels,
                   "their label files, or the folder of these; a label file has the name of its "
                   "track but for the ending")
      ->required();
  verb->add_option("--columns",
                   options->columns,
                   "measures to be fitted, with commas between (all columns of numbers; neither "
                   "\"frame\" nor NAME_sm nor head_NAME)")
      ->delimiter(',');
  verb->add_option("--openings",
                   options->openings,
                   "which of them are openings, never below 0 (those named inner_h..., "
                   "inner_area...); talkers differ in these by a factor, else by a constant")
      ->delimiter(',');
  verb->add_option("--time-column", options->time_column, "its name ends in _ms or _s");
  verb->add_option("--theta",
                   options->theta,
                   "best (default): one, with --leave-one-out that which tells left-out clips "
                   "best; one: by least squares; sides: before and after the peak; class; "
                   "class-sides; or a number in 1/ms")
      ->check(theta_check());
  verb->add_option("--shrinkage",
                   options->shrinkage,
                   "strength of the pull, 0 for none (chosen by --leave-one-out, else 0.5)")
      ->check(finite_number())
      ->check(CLI::Range(0.0, 100.0));
  verb->add_flag("--leave-one-out",
                 options->leave_one_out,
                 "also fit all clips but one and tell that one; each in turn");
  verb->add_flag("--same-talker",
                 options->same_talker,
                 "all clips are of one talker: no gain and no offset for each");
  verb->add_option(
          "-o,--output", options->output, "JSON file of the segments' definitions to be written")
      ->check(in_a_folder_that_exists());
  verb->callback([options, &chosen] { chosen = [options] { return fit_segments(*options); }; });
}

}  // namespace bimodal::runner
