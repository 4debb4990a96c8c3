#include "runner/devices/portaudio/output_channels.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <portaudio.h>

#include "runner/devices/device_error.hpp"

namespace bimodal::runner {

int choose_channels(const AudioDevice& device,
                    int wanted,
                    const std::function<bool(int)>& accepts) {
  if (wanted == 0) return std::min(device.channels, 2);
  if (device.channels < wanted) {
    throw DeviceError{fmt::format(
        "cannot use the sound output '{}': the protocol asks for its channel {}, and it has {}; "
        "choose another device by --audio, or other channels in /sound/channels and "
        "/triggers/click/channel",
        describe(device),
        wanted,
        device.channels)};
  }
  for (const int count : std::array{wanted, wanted + wanted % 2, device.channels}) {
    if (count <= device.channels && accepts(count)) return count;
  }
  return wanted;  // opening it says what is wrong
}

int choose_channels(const AudioDevice& device, int wanted, double rate) {
  return choose_channels(device, wanted, [&](int count) {
    const SilencedStderr quiet;
    PaStreamParameters parameters{};
    parameters.device = device.index;
    parameters.channelCount = count;
    parameters.sampleFormat = paFloat32;
    parameters.suggestedLatency = device.safe_latency;
    return Pa_IsFormatSupported(nullptr, &parameters, rate) == paFormatIsSupported;
  });
}

}  // namespace bimodal::runner
