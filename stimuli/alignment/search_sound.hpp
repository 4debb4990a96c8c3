#pragma once

#include <cstdint>
#include <vector>

#include "stimuli/audio/clip.hpp"

namespace bimodal {

/// A recording made ready for the search for phones.
struct SearchSound {
  std::vector<std::int16_t> samples;  ///< at CepstraMaker::kRate
  Duration padding{};                 ///< before and after the recording
};

/// Resamples to 16 kHz, takes the mean away and brings the peak to 0.9, which makes the search
/// indifferent to the recording's level. At both ends 0.2 s of white noise are added at the level
/// of the quietest 2 % of the recording's 10 ms, but at least 40 dB below the peak, so that rest is
/// found even where a recording is cut flush to its word; and through all of it noise 60 dB below
/// the peak, the room that the acoustic model expects: beside stretches of digital zero the weak
/// end of a word would pass for the word. The noise is the same every time.
///
/// Throws Error if there are no samples, one is not finite, or nothing is louder than -80 dB re
/// full scale.
[[nodiscard]] SearchSound search_sound(const Clip& sound);

}  // namespace bimodal
