#pragma once

#include <cstddef>
#include <span>

#include "stimuli/audio/clip.hpp"
#include "stimuli/audio/fourier.hpp"
#include "stimuli/base/quantity.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

/// What can be measured of the sound of an item.
struct ItemSound {
  Decibels speech;          ///< RMS from the first phone's start to the last one's end, 80-8000 Hz
  Decibels before;          ///< the same of the margin before; -infinity if it is empty or silent
  Decibels after;           ///< of the margin after
  std::size_t clipped = 0;  ///< see clipped_runs
};

/// How often a sound was cut off at full scale: runs of at least 3 equal samples of at least 0.99.
[[nodiscard]] std::size_t clipped_runs(std::span<const float> samples);

/// Measures a stretch of a recording in which `speech` is the word. Throws Error if the word is
/// empty or not within the sound.
[[nodiscard]] ItemSound measure_item(const Clip& sound,
                                     const SpeechInterval& item,
                                     const SpeechInterval& speech,
                                     FourierTransform& fourier);

}  // namespace bimodal
