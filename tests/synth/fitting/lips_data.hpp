#pragma once

// The six measured clips that some tests need and that are no part of the project.

#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/labels/label_file.hpp"
#include "synth/fitting/measured_clip.hpp"

namespace bimodal::synth {

inline constexpr std::array kLipClips{
    "bbaf2n", "id2_vcd_swwp2s", "brbk7n", "lbax4n", "pwij3p", "sbwe5n"};

/// The folder; absent where the data is not.
inline std::optional<std::filesystem::path> lips_folder() {
  const char* const data = std::getenv("BIMODAL_TEST_DATA");
  if (data == nullptr) return std::nullopt;
  const auto folder = std::filesystem::path{data} / "lips";
  if (!std::filesystem::exists(folder)) return std::nullopt;
  return folder;
}

inline std::vector<MeasuredClip> lip_clips(const std::filesystem::path& folder,
                                           const std::string& column) {
  std::vector<MeasuredClip> clips;
  for (const std::string clip : kLipClips) {
    const auto labels = read_labels(folder / (clip + ".TextGrid"));
    const auto track = read_track(folder / (clip + ".csv"), {.columns = {column}});
    clips.push_back(measured_clip(clip,
                                  track,
                                  track.columns.front(),
                                  utterance_of(*phone_tier(labels), labels.end),
                                  clip + ".TextGrid",
                                  kind_of(column) == MeasureKind::Position));
  }
  return clips;
}

}  // namespace bimodal::synth
