#pragma once

#include <functional>

#include "runner/devices/portaudio/portaudio_session.hpp"

namespace bimodal::runner {

/// How many channels of an output to open so that the first `wanted` are there (0: two, or its only
/// one). Drivers may refuse odd numbers, or any but all of theirs; `accepts` says whether this one
/// takes a number. Throws DeviceError if the device has too few.
[[nodiscard]] int choose_channels(const AudioDevice& device,
                                  int wanted,
                                  const std::function<bool(int)>& accepts);

/// The same, asking PortAudio.
[[nodiscard]] int choose_channels(const AudioDevice& device, int wanted, double rate);

}  // namespace bimodal::runner
