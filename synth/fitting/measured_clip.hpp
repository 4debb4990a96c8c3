#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "stimuli/timeline/utterance.hpp"
#include "synth/fitting/part.hpp"
#include "synth/fitting/track_file.hpp"

namespace bimodal::synth {

/// What a measure is to the model.
enum class MeasureKind : std::uint8_t {
  Opening,   ///< never below 0 (lips collide); talkers differ by a factor
  Position,  ///< may have any value; talkers differ by a constant
};

/// Openings are the columns whose names begin with inner_h or inner_area.
[[nodiscard]] MeasureKind kind_of(std::string_view column);

/// One measure of one recording, and what is said in it.
struct MeasuredClip {
  std::string name;
  std::vector<SpokenPart> spoken;
  double speech_start_ms = 0;
  double speech_end_ms = 0;
  double reference = 0;         ///< what `values` are relative to: 0, or the mean over the speech
  std::vector<double> time_ms;  ///< from kMargin before the speech to kMargin behind it
  std::vector<double> values;   ///< one per instant, minus the reference
};

/// Longer before the speech the mouth is often open to breathe in, which no phones predict.
inline constexpr Milliseconds kMargin{100};

/// Cuts a clip out of a track. `relative`: to the mean over the speech. `name` is the recording's,
/// `labels` the label file's, for messages. Throws Error, naming both files, if nothing is said, or
/// the track has fewer than five instants in the window or none within the speech.
[[nodiscard]] MeasuredClip measured_clip(const std::string& name,
                                         const Track& track,
                                         const TrackColumn& column,
                                         const Utterance& utterance,
                                         const std::string& labels,
                                         bool relative);

/// The part of the window, 0 to 1, that the track spans; below 1 where it begins late or ends
/// early.
[[nodiscard]] double coverage(const MeasuredClip& clip);

}  // namespace bimodal::synth
