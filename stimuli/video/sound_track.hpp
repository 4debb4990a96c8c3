#pragma once

#include <filesystem>

#include "stimuli/audio/clip.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal {

/// A stretch of a media file, counted from the common zero of its tracks: the earlier of the starts
/// of sound and picture. `end` at the latest representable instant: to the end.
struct MediaSpan {
  Duration start{};
  Duration end = Duration::max();
};

/// The sound of a stretch of a media file (FFmpeg decodes, the mean of all channels, libsoxr
/// changes the rate if one is asked for; 0 Hz: the file's own). Exact to the sample: a sound that
/// starts later than the picture is preceded by silence, gaps in its time stamps are filled with
/// silence, priming and padding that the container declares are left out. Throws Error, naming the
/// file, if it has no sound, the stretch is not within it, lasts more than an hour, or it cannot be
/// decoded.
[[nodiscard]] Clip read_sound_track(const std::filesystem::path& file,
                                    Hertz rate = Hertz{0},
                                    MediaSpan span = {});

}  // namespace bimodal
