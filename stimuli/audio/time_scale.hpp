#pragma once

#include "stimuli/audio/clip.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

inline constexpr double kSlowest = 0.25;
inline constexpr double kFastest = 4.0;

/// The same sound `rate` times as fast without change of pitch (Rubber Band, R3 engine, offline,
/// study and process, with its start-up delay removed). The result has nearest_integer(samples /
/// rate) samples, ties up, and instant t of the sound stands at t / rate within 10 ms. At rate 1
/// the very samples. Equal input gives equal output, bit for bit, on one machine. Throws Error
/// unless kSlowest <= rate <= kFastest.
[[nodiscard]] Clip change_rate(const Clip& sound, double rate);

/// When the phones then sound.
[[nodiscard]] Utterance change_rate(const Utterance& utterance, double rate);

/// Backwards.
[[nodiscard]] Clip reversed(Clip sound);
[[nodiscard]] Utterance reversed(const Utterance& utterance);

/// The same length, silent from `instant` on, with a raised-cosine fall over the `ramp` before it.
[[nodiscard]] Clip gated(Clip sound, Duration instant, Duration ramp);

}  // namespace bimodal
