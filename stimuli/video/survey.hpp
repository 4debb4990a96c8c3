#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "stimuli/video/libav.hpp"
#include "stimuli/video/media_file.hpp"

namespace bimodal::libav {

/// When the frames of a picture track are seen, on the file's clock, as far as its packets were
/// looked through.
struct FrameTimes {
  AVRational rate{.num = 0, .den = 1};  ///< frames a second; 0/1 if unknown
  bool regular = false;                 ///< frame i begins at the first one's time + i / rate
  bool complete = false;                ///< every packet names its time, no two the same
  std::vector<Duration> starts;         ///< in order; of those looked through
};

/// All that must be known of a file before a stretch of it is decoded.
struct Survey {
  Media media;
  Duration zero{};  ///< the common zero (MediaSpan) on the file's clock
  FrameTimes times;
  AVRational pixel_aspect{.num = 1, .den = 1};
  bool whole = false;                 ///< looked through to its end: the lengths are measured
  std::optional<Duration> torn_from;  ///< from the zero: ends here, although its header claims more
};

/// Looks through the first minute of the file, or, if its frames are not regular, up to `until` (on
/// the common zero), without decoding more than the first frame of each track. Throws Error as
/// examine_media does.
[[nodiscard]] Survey survey_of(const std::filesystem::path& file, Duration until = {});

/// `span` within the length of the file. Throws Error if it is not: begins before 0, has no length,
/// or ends more than 50 ms after the file.
[[nodiscard]] Duration end_within(const Survey& survey,
                                  const std::filesystem::path& file,
                                  Duration start,
                                  Duration end);

}  // namespace bimodal::libav
