#pragma once

#include "stimuli/audio/clip.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

inline constexpr double kSlowest = 0.25;
inline constexpr double kFastest = 4.0;

/// The same sound `rate` times as fast without change of pitch (Rubber Band, R3 engine, offline,
/// study and process, with silence around it while it is stretched, so that a word of a tenth of a
/// second is, too). The result has nearest_integer(samples / rate) samples, ties up. At rate 1 the
/// very samples. Equal input gives equal output, bit for bit, on one machine. Throws Error unless
/// kSlowest <= rate <= kFastest.
///
/// Instant t of the sound stands at t / rate. Measured with tone bursts and single samples at 48
/// kHz, the largest error of an onset or offset (half of the amplitude) is 4 ms from rate 0.7 to 4;
/// slower, the sound is smeared with its time scale: 13 ms at rate 1/3, which are 4 ms of the
/// sound's own time. The other engine and shorter windows were worse: R2 8 to 25 ms, R3 with short
/// windows 2 to 41 ms from rate 1.5 to 4. The level of a steady tone changes by less than 0.1 dB;
/// at rate 2, speech loses up to 3 dB of its noise in an octave band (3 to 6 kHz of "sheep").
[[nodiscard]] Clip change_rate(const Clip& sound, double rate);

/// When the phones then sound: every boundary at its time / rate, to the nearest nanosecond.
[[nodiscard]] Utterance change_rate(const Utterance& utterance, double rate);

/// Backwards.
[[nodiscard]] Clip reversed(Clip sound);
[[nodiscard]] Utterance reversed(const Utterance& utterance);

/// The same length, silent from the sample nearest to `instant` on, with a raised-cosine fall over
/// the `ramp` before it. Throws Error if either is negative.
[[nodiscard]] Clip gated(Clip sound, Duration instant, Duration ramp);

}  // namespace bimodal
