#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bimodal::synth {

struct TrackColumn {
  std::string name;
  std::vector<double> values;  ///< finite, one per instant
};

/// Measures of a talker's face in the course of time.
struct Track {
  std::string file;             ///< as it was named
  std::vector<double> time_ms;  ///< increasing; at least two, which need not be equally far apart
  std::vector<TrackColumn> columns;

  /// nullptr if there is none of this name.
  [[nodiscard]] const TrackColumn* column(std::string_view name) const;
};

/// What of a table is wanted.
struct TrackRequest {
  std::string time_column;  ///< its name ends in _ms or _s; empty: time_ms or time_s
  /// Empty: all whose first field is a number, except the time, "frame" and names that begin with
  /// "head_" or end in "_sm" (head motion that was taken out, smoothed copies).
  std::vector<std::string> columns;
};

/// Reads a table with commas between fields and the names of the columns in the first line; fields
/// have no quotation marks. Throws Error that lists what is wrong with it, each with file, line and
/// remedy: columns that are missing, lines with too few or too many fields, what is no finite
/// number in a wanted column, times that do not increase.
[[nodiscard]] Track read_track(const std::filesystem::path& file, const TrackRequest& request);

/// As read_track, from a text; `name` is the file's name for messages.
[[nodiscard]] Track parse_track(std::string_view text,
                                const std::string& name,
                                const TrackRequest& request);

/// The column at `time_ms`, by straight lines between the instants of the track. Precondition: the
/// instant does not lie outside of the track.
[[nodiscard]] double interpolated(const Track& track, const TrackColumn& column, double time_ms);

}  // namespace bimodal::synth
