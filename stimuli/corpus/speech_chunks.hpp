#pragma once

#include <vector>

#include "stimuli/audio/band.hpp"
#include "stimuli/audio/clip.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

/// How speech is told from the room.
struct ChunkOptions {
  Band band;                                       ///< in which levels are taken
  Duration frame = std::chrono::milliseconds{10};  ///< of one level
  Decibels opens{15.0};                            ///< above the floor: speech
  Decibels stays{8.0};                             ///< above the floor: still speech
  Decibels range{45.0};                            ///< what is further below the loudest is not
  Duration longest_pause = std::chrono::milliseconds{200};  ///< within a chunk
  Duration shortest = std::chrono::milliseconds{50};        ///< chunk; clicks are shorter
};

/// The level of each whole frame of a sound within a band, in dB re full scale, none below -120 dB.
/// The band is limited to half the sampling rate. The sound goes through a high-pass and a low-pass
/// of second order (Butterworth) first, so that levels of one frame are not smeared.
[[nodiscard]] std::vector<double> frame_levels(const Clip& sound, const Band& band, Duration frame);

/// The stretches of a recording in which somebody speaks, in order, without overlap: candidates for
/// words, coughs among them.
///
/// The floor of each moment is the 10th percentile of the levels within 5 s to either side. A chunk
/// begins where the level rises to `opens` above it, extends both ways as long as it is `stays`
/// above it (hysteresis), bridges pauses up to `longest_pause` (the closure of a stop), and is
/// dropped if it is shorter than `shortest`. Edges are multiples of `frame`. Silence has none.
[[nodiscard]] std::vector<SpeechInterval> find_speech(const Clip& sound,
                                                      const ChunkOptions& options = {});

}  // namespace bimodal
