#pragma once

#include <span>

#include "stimuli/timeline/phone.hpp"
#include "synth/voice/festival.hpp"
#include "synth/voice/voice.hpp"

namespace bimodal::synth {

/// The item that Festival's output makes: samples to full-scale units at the voice's own rate,
/// segments to timed phones without gaps. The last rest is extended or cut to the end of the sound
/// (the diphone voice appends about 28 ms to what it labels). A syllabic consonant (el em en) is
/// halved into AX and the consonant.
///
/// With a pronunciation, the phones are named as asked, and each must be what was said, up to the
/// reductions of realises(). Throws Error if they are not, if a segment is unknown or ends before
/// it begins, or if there is no rest at both ends.
[[nodiscard]] SpokenItem spoken_item(const FestivalSpeech& speech,
                                     std::span<const Phone> pronunciation);

}  // namespace bimodal::synth
