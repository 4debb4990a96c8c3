#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stimuli/timeline/utterance.hpp"
#include "synth/fitting/track_file.hpp"

namespace bimodal::runner {

/// Measures of one recording, and what is said in it.
struct LabelledTrack {
  std::string name;  ///< of the recording: the file of measures without folder and ending
  synth::Track track;
  std::string labels;  ///< the label file
  Utterance utterance;
};

/// The tracks, where a folder stands for the tables in it (.csv) that have a label file in the
/// folder `labels`, or beside them where that is no folder; in the order of their names. Throws
/// Error for a folder without any.
[[nodiscard]] std::vector<std::string> without_folders(const std::vector<std::string>& tracks,
                                                       const std::vector<std::string>& labels);

/// The label file of each track: the one of the same name but for the ending. `labels` are files,
/// or one folder of them; a single track may have a single label file of another name. Throws Error
/// that lists the files that are not there, the tracks without labels, and those of one name.
[[nodiscard]] std::vector<std::filesystem::path> labels_of_tracks(
    const std::vector<std::string>& tracks, const std::vector<std::string>& labels);

/// Reads both. Throws Error as read_track and read_labels, or if there is no tier of phones.
[[nodiscard]] LabelledTrack read_labelled_track(const std::filesystem::path& track,
                                                const std::filesystem::path& labels,
                                                const synth::TrackRequest& request);

}  // namespace bimodal::runner
