#include "runner/cli/labelled_track.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "stimuli/labels/label_file.hpp"

namespace bimodal::runner {

namespace {

namespace fs = std::filesystem;

constexpr std::array kEndings{".TextGrid", ".lab", ".align", ".labels.csv"};

/// The label file in a folder for a recording of this name.
std::optional<fs::path> label_file_in(const fs::path& folder, const std::string& name) {
  for (const auto* const ending : kEndings) {
    const auto file = folder / (name + ending);
    if (fs::exists(file)) return file;
  }
  return std::nullopt;
}

std::optional<fs::path> label_file_among(const std::vector<std::string>& files,
                                         const std::string& name) {
  const auto found =
      std::ranges::find_if(files, [&](const fs::path& file) { return file.stem() == name; });
  if (found == files.end()) return std::nullopt;
  return *found;
}

}  // namespace

std::vector<std::string> without_folders(const std::vector<std::string>& tracks,
                                         const std::vector<std::string>& labels) {
  std::vector<std::string> found;
  for (const auto& track : tracks) {
    if (!fs::is_directory(track)) {
      found.push_back(track);
      continue;
    }
    const bool has_folder = labels.size() == 1 && fs::is_directory(labels.front());
    const auto folder = has_folder ? fs::path{labels.front()} : fs::path{track};
    std::vector<std::string> tables;
    for (const auto& entry : fs::directory_iterator{track}) {
      const auto& file = entry.path();
      const bool is_table = file.extension() == ".csv" && !file.string().ends_with(".labels.csv");
      if (is_table && label_file_in(folder, file.stem().string())) tables.push_back(file.string());
    }
    if (tables.empty()) {
      throw Error{fmt::format(
          "{}: there is no table (.csv) with labels of its name in {}", track, folder.string())};
    }
    std::ranges::sort(tables);
    found.insert(found.end(), tables.begin(), tables.end());
  }
  return found;
}

std::vector<fs::path> labels_of_tracks(const std::vector<std::string>& tracks,
                                       const std::vector<std::string>& labels) {
  std::string mistakes;
  const auto complain = [&](const std::string& mistake) {
    mistakes += (mistakes.empty() ? "" : "\n") + mistake;
  };
  for (const auto* const files : {&tracks, &labels}) {
    for (const auto& file : *files) {
      if (!fs::exists(file)) complain(file + ": there is no such file; look at the spelling");
    }
  }
  if (!mistakes.empty()) throw Error{mistakes};
  const bool in_folder = labels.size() == 1 && fs::is_directory(labels.front());
  if (tracks.size() == 1 && labels.size() == 1 && !in_folder) return {labels.front()};
  std::vector<fs::path> found;
  std::map<std::string, std::string> named;
  for (const auto& track : tracks) {
    const auto name = fs::path{track}.stem().string();
    if (const auto [other, is_new] = named.emplace(name, track); !is_new) {
      complain(
          fmt::format("{}: a recording of this name, {}, is there already; give it once, or "
                      "rename it with its labels",
                      track,
                      other->second));
      continue;
    }
    const auto file =
        in_folder ? label_file_in(labels.front(), name) : label_file_among(labels, name);
    if (file) {
      found.push_back(*file);
    } else {
      complain(fmt::format("{}: there are no labels of this recording{}; give --labels {}.TextGrid",
                           track,
                           in_folder ? " in " + labels.front() : std::string{},
                           name));
    }
  }
  if (!mistakes.empty()) throw Error{mistakes};
  return found;
}

LabelledTrack read_labelled_track(const fs::path& track,
                                  const fs::path& labels,
                                  const synth::TrackRequest& request) {
  const auto read = read_labels(labels);
  const auto* const tier = phone_tier(read);
  if (tier == nullptr) {
    std::vector<std::string> names;
    for (const auto& one : read.tiers) names.push_back(fmt::format("\"{}\"", one.name));
    throw Error{fmt::format(
        "{}: no tier is named \"phones\" or the like; it has {}; let the tier of phones have that "
        "name, or make one with: bimodal align SOUND --text \"...\" -o {}.TextGrid",
        labels.string(),
        names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")),
        track.stem().string())};
  }
  try {
    return {.name = track.stem().string(),
            .track = synth::read_track(track, request),
            .labels = labels.string(),
            .utterance = utterance_of(*tier, read.end)};
  } catch (const Error& error) {
    const std::string said = error.what();
    const bool names_file = said.starts_with(track.string()) || said.starts_with(labels.string());
    throw Error{names_file ? said : fmt::format("{}: {}", labels.string(), said)};
  }
}

}  // namespace bimodal::runner
