#pragma once

#include <filesystem>
#include <optional>

#include "stimuli/video/frame_times.hpp"
#include "stimuli/video/libav.hpp"
#include "stimuli/video/media_file.hpp"

namespace bimodal::libav {

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

/// The end of a stretch, at most 50 ms after that of the file. Throws Error if the stretch begins
/// before 0 or after the file, has no length, ends later, or goes beyond where the file breaks off.
[[nodiscard]] Duration end_within(const Survey& survey,
                                  const std::filesystem::path& file,
                                  Duration start,
                                  Duration end);

}  // namespace bimodal::libav
