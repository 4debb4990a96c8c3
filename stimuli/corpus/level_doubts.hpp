#pragma once

#include <span>

#include "stimuli/corpus/built_recording.hpp"

namespace bimodal {

/// Doubts items that are more than 12 dB from the median level of their talker's items; words of
/// running speech, which ends weaker than it begins, only if they are more than 30 dB from it: what
/// somebody has labelled there is no speech.
void doubt_levels(std::span<BuiltRecording> recordings);

}  // namespace bimodal
