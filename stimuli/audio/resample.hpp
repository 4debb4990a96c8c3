#pragma once

#include "stimuli/audio/clip.hpp"

namespace bimodal {

/// The same sound at another sampling rate (libsoxr, very high quality, linear phase): sample 0
/// stays where it is in time and nothing is delayed. Before and after the sound is silence.
/// The result has nearest_integer(samples * rate / sound.rate) samples, ties up. Equal input gives
/// equal output, bit for bit, on one machine. At an equal rate the very samples are returned.
/// Throws Error if either rate is not positive or their ratio is beyond 1000.
[[nodiscard]] Clip resample(const Clip& sound, Hertz rate);

}  // namespace bimodal
