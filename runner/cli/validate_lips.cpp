#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "runner/cli/lip_comparison.hpp"
#include "runner/cli/lip_tables.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/cli/verbs.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/timeline/inventory_file.hpp"

namespace bimodal::runner {

namespace {

namespace fs = std::filesystem;

struct ValidateLipsOptions {
  std::string folder;
  std::vector<std::string> clips;  ///< empty: all
  std::string tracks;              ///< folder of predictions; empty: the project's face
  std::string segments = "english";
  std::string time_column;
  std::string output;
};

/// The recordings of the folder that have a table and a label file, in the order of their names.
std::vector<std::string> clips_in(const ValidateLipsOptions& options) {
  if (!fs::is_directory(options.folder)) {
    throw Error{
        fmt::format("'{}' is no folder; give one with CLIP.csv and CLIP.TextGrid", options.folder)};
  }
  std::vector<std::string> clips;
  for (const auto& entry : fs::directory_iterator{options.folder}) {
    auto labels = entry.path();
    labels.replace_extension(".TextGrid");
    if (entry.path().extension() == ".csv" && fs::exists(labels)) {
      clips.push_back(entry.path().stem().string());
    }
  }
  std::ranges::sort(clips);
  if (clips.empty()) {
    throw Error{
        fmt::format("'{}' has no CLIP.csv with a CLIP.TextGrid beside it; measured lips "
                    "need both",
                    options.folder)};
  }
  for (const auto& clip : options.clips) {
    if (std::ranges::find(clips, clip) != clips.end()) continue;
    throw Error{fmt::format(
        "'{}' has no clip \"{}\"; it has {}", options.folder, clip, fmt::join(clips, ", "))};
  }
  return options.clips.empty() ? clips : options.clips;
}

std::vector<LabelledTrack> read_recordings(const ValidateLipsOptions& options) {
  std::vector<LabelledTrack> recordings;
  std::string mistakes;
  for (const auto& clip : clips_in(options)) {
    const auto file = fs::path{options.folder} / clip;
    try {
      recordings.push_back(
          read_labelled_track(file.string() + ".csv",
                              file.string() + ".TextGrid",
                              {.time_column = options.time_column, .columns = {}}));
    } catch (const Error& error) {
      mistakes += (mistakes.empty() ? "" : "\n") + std::string{error.what()};
    }
  }
  if (!mistakes.empty()) throw Error{mistakes};
  return recordings;
}

/// The head and what it says with; made once.
struct Face {
  synth::SegmentTable segments;
  synth::Head head;
};

ExitCode validate_lips(const ValidateLipsOptions& options) {
  const auto recordings = read_recordings(options);
  std::optional<Face> face;
  if (options.tracks.empty()) {
    face.emplace(Face{synth::SegmentTable{inventory_file(options.segments)},
                      synth::Head{asset("synth/assets/head")}});
  }
  const bool to_terminal = isatty(STDERR_FILENO) == 1;
  std::vector<ClipComparison> compared;
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    const auto& recording = recordings[i];
    if (to_terminal) {
      fmt::print(stderr, "\rclip {} of {}: {:<20} ", i + 1, recordings.size(), recording.name);
      std::fflush(stderr);
    }
    const auto predicted =
        face ? face_track(recording.utterance, face->segments, face->head)
             : synth::read_track(fs::path{options.tracks} / (recording.name + ".csv"),
                                 {.time_column = options.time_column, .columns = {}});
    compared.push_back(compare(recording, predicted));
  }
  if (to_terminal) fmt::print(stderr, "\r{:60}\r", "");
  print_comparison(compared);
  if (!options.output.empty()) {
    write_file(options.output, comparison_csv(compared));
    fmt::print("{}: {} compared\n", options.output, counted(compared.size(), "clip"));
  }
  return ExitCode::Done;
}

}  // namespace

void add_validate_lips(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "validate-lips",
      "Compares lips with measured ones. DIR has a table CLIP.csv (time_ms or time_s; inner_h,\n"
      "outer_w, ... in mm) and labels of its phones CLIP.TextGrid for each recording. The face "
      "says\n"
      "these phones; or --tracks names a folder of what another talking head does in the same\n"
      "clips. Told are, from 100 ms before the speech to 100 ms behind it: r within each clip, "
      "the\n"
      "root mean square error, the same after the best offset and gain for each clip; when lips\n"
      "close and round; the means at the centres of phones.\n"
      "Exit code: 0 done, 3 errors.\n\n"
      "Examples:\n"
      "  bimodal validate-lips lips\n"
      "  bimodal validate-lips lips --clips bbaf2n,lbax4n --segments mine.json\n"
      "  bimodal validate-lips lips --tracks other-head -o lips-report.csv");
  auto options = std::make_shared<ValidateLipsOptions>();
  verb->add_option("DIR", options->folder, "the folder of measured clips")->required();
  verb->add_option("--clips", options->clips, "only these, with commas between (all)")
      ->delimiter(',');
  auto* const tracks = verb->add_option(
      "--tracks", options->tracks, "folder of predicted tables CLIP.csv, instead of the face");
  verb->add_option("--segments",
                   options->segments,
                   "segment inventory that the face speaks with, instead of the shipped one")
      ->excludes(tracks);
  verb->add_option("--time-column", options->time_column, "its name ends in _ms or _s");
  verb->add_option("-o,--output",
                   options->output,
                   "CSV file to be written: clip,phone,measure,quantity,n,value")
      ->check(in_a_folder_that_exists());
  verb->callback([options, &chosen] { chosen = [options] { return validate_lips(*options); }; });
}

}  // namespace bimodal::runner
