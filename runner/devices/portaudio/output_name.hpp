#pragma once

#include <string>

#include "runner/devices/portaudio/portaudio_session.hpp"

namespace bimodal::runner {

/// "system (JACK Audio Connection Kit)": by which a device is known again, whatever its index.
[[nodiscard]] std::string lasting_name(const AudioDevice& device);

/// The lasting name of the output that is meant (see choose_device). Throws DeviceError if none is.
[[nodiscard]] std::string output_name(const std::string& wanted);

}  // namespace bimodal::runner
