#include "runner/devices/portaudio/portaudio_stream.hpp"

#include <pa_linux_alsa.h>

namespace bimodal::runner {

PaError start_stream(PaError opened, PaStream* stream, const AudioDevice& device) {
  if (opened != paNoError) return opened;
  if (device.host == "ALSA") PaAlsa_EnableRealtimeScheduling(stream, 1);
  const auto started = Pa_StartStream(stream);
  if (started != paNoError) Pa_CloseStream(stream);
  return started;
}

}  // namespace bimodal::runner
