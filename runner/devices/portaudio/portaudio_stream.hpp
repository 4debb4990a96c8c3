#pragma once

#include <portaudio.h>

#include "runner/devices/portaudio/portaudio_session.hpp"

namespace bimodal::runner {

/// Starts a stream that Pa_OpenStream has opened with this outcome, its callback with real-time
/// priority where the system allows it (JACK's server sees to it for its clients). On failure the
/// stream is closed. Returns what went wrong, or paNoError.
[[nodiscard]] PaError start_stream(PaError opened, PaStream* stream, const AudioDevice& device);

}  // namespace bimodal::runner
