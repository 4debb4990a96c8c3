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
/// changes the rate if one is asked for; 0 Hz: the file's own). Exact to the sample: any stretch
/// holds the very samples of the whole, because decoding always begins with the file (about 100
/// times as fast as the sound). It has nearest(end) - nearest(start) samples at the file's rate,
/// silent where the track has begun later or ended earlier than the picture; without an end, it
/// ends with the track. Gaps of more than 10 ms in the time stamps are filled with silence,
/// overlaps of more than 10 ms left out; smaller deviations are taken for rounding. Priming and
/// padding that the container declares are left out. Throws Error, naming the file, if it has no
/// sound, the stretch is not within it (50 ms more at the end are borne), lasts more than an hour,
/// the rate is outside 4 to 384 kHz or changes, a sample is not a finite number, or it cannot be
/// decoded.
[[nodiscard]] Clip read_sound_track(const std::filesystem::path& file,
                                    Hertz rate = Hertz{0},
                                    MediaSpan span = {});

}  // namespace bimodal
