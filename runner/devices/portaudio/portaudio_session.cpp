#include "runner/devices/portaudio/portaudio_session.hpp"

#include <algorithm>

#include <fcntl.h>
#include <fmt/format.h>
#include <portaudio.h>
#include <unistd.h>

#include "runner/devices/device_error.hpp"

namespace bimodal::runner {

namespace {

AudioDevice output_at(PaDeviceIndex index, const PaDeviceInfo& found) {
  const PaHostApiInfo* const host = Pa_GetHostApiInfo(found.hostApi);
  return {.index = index,
          .name = found.name,
          .host = host != nullptr ? host->name : "unknown",
          .channels = found.maxOutputChannels,
          .default_rate = found.defaultSampleRate,
          .safe_latency = found.defaultHighOutputLatency,
          .is_default = index == Pa_GetDefaultOutputDevice()};
}

AudioDevice input_at(PaDeviceIndex index, const PaDeviceInfo& found) {
  auto device = output_at(index, found);
  device.channels = found.maxInputChannels;
  device.safe_latency = found.defaultHighInputLatency;
  device.is_default = index == Pa_GetDefaultInputDevice();
  return device;
}

}  // namespace

SilencedStderr::SilencedStderr() : kept_{::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0)} {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

SilencedStderr::~SilencedStderr() {
  if (kept_ < 0) return;
  ::dup2(kept_, STDERR_FILENO);
  ::close(kept_);
}

std::string describe(const AudioDevice& device) {
  return fmt::format("{}: {} ({}), {} channels, {} samples per second{}",
                     device.index,
                     device.name,
                     device.host,
                     device.channels,
                     device.default_rate,
                     device.is_default ? ", default" : "");
}

PortaudioSession::PortaudioSession() {
  const SilencedStderr quiet;
  const PaError failure = Pa_Initialize();
  if (failure != paNoError) {
    throw DeviceError{fmt::format("cannot start PortAudio: {}; check the sound system",
                                  Pa_GetErrorText(failure))};
  }
  for (PaDeviceIndex index = 0; index < Pa_GetDeviceCount(); ++index) {
    const PaDeviceInfo* const found = Pa_GetDeviceInfo(index);
    if (found == nullptr) continue;
    if (found->maxOutputChannels > 0) devices_.push_back(output_at(index, *found));
    if (found->maxInputChannels > 0) inputs_.push_back(input_at(index, *found));
  }
}

PortaudioSession::~PortaudioSession() {
  if (abandoned_) return;
  const SilencedStderr quiet;
  Pa_Terminate();
}

const AudioDevice& choose_device(const std::vector<AudioDevice>& devices,
                                 const std::string& wanted,
                                 const SoundUse& use) {
  if (devices.empty()) {
    throw DeviceError{fmt::format(
        "cannot open a {}: this machine has none; connect one, start a sound server, or {}",
        use.device,
        use.remedy)};
  }
  if (wanted.empty()) {
    // Where a JACK server runs it is meant: PortAudio would take ALSA's detour to the same server.
    const auto jack = std::ranges::find_if(
        devices, [](const AudioDevice& device) { return device.host.starts_with("JACK"); });
    if (jack != devices.end()) return *jack;
    const auto chosen = std::ranges::find(devices, true, &AudioDevice::is_default);
    return chosen != devices.end() ? *chosen : devices.front();
  }
  const auto meant = [&](auto condition) { return std::ranges::find_if(devices, condition); };
  auto chosen = meant([&](const AudioDevice& device) {
    return std::to_string(device.index) == wanted || device.name == wanted;
  });
  if (chosen == devices.end()) {
    chosen = meant([&](const AudioDevice& device) {
      return describe(device).find(wanted) != std::string::npos;
    });
  }
  if (chosen != devices.end()) return *chosen;
  std::string list;
  for (const auto& device : devices) list += "\n  " + describe(device);
  throw DeviceError{
      fmt::format("cannot open the {} '{}': there is none of that name; "
                  "choose one of these or {}:{}",
                  use.device,
                  wanted,
                  use.remedy,
                  list)};
}

}  // namespace bimodal::runner
