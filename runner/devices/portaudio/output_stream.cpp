#include "runner/devices/portaudio/output_stream.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

#include <fmt/format.h>

#include "runner/devices/device_error.hpp"
#include "runner/devices/monotonic_clock.hpp"
#include "runner/devices/portaudio/output_channels.hpp"
#include "runner/devices/portaudio/portaudio_stream.hpp"

namespace bimodal::runner {

namespace {

constexpr Duration kFade = std::chrono::milliseconds{5};
constexpr Duration kLongestStart = std::chrono::seconds{3};
constexpr Duration kLostAfter = std::chrono::seconds{1};
constexpr Duration kStartSpan = std::chrono::milliseconds{500};
constexpr std::size_t kFewestReadings = 16;
constexpr std::size_t kStartReadings = 64;  ///< suffice, however short their span

CallbackTimes told(const OutputStream::Reading& reading) {
  return {reading.sample, Instant{Duration{reading.entry_ns}}, reading.current, reading.output};
}

}  // namespace

OutputStream::OutputStream(const PortaudioOptions& options)
    : device{choose_device(session.devices(), options.device)},
      rate{options.rate},
      channels{static_cast<std::size_t>(
          choose_channels(device, options.channels, options.rate.count()))},
      mixer{nearest_sample(kFade, options.rate).count()},
      follower{options.rate} {
  open(options);
  try {
    await_clock();
  } catch (...) {
    Pa_AbortStream(stream);
    Pa_CloseStream(stream);
    throw;
  }
}

OutputStream::~OutputStream() {
  if (follower.playback().lost) {
    session.abandon();  // PortAudio would wait for ever for a sound server that is gone
    return;
  }
  const SilencedStderr quiet;
  Pa_AbortStream(stream);  // after it, the callback does not run
  Pa_CloseStream(stream);
}

void OutputStream::open(const PortaudioOptions& options) {
  const SilencedStderr quiet;
  PaStreamParameters parameters{};
  parameters.device = device.index;
  parameters.channelCount = static_cast<int>(channels);
  parameters.sampleFormat = paFloat32;
  // Sounds are scheduled ahead, so that a short latency would gain nothing and risk gaps.
  parameters.suggestedLatency = device.safe_latency;
  // paClipOff: clipping is found and reported before the session, not hidden here.
  PaError failure = Pa_OpenStream(&stream,
                                  nullptr,
                                  &parameters,
                                  rate.count(),
                                  options.buffer,
                                  paClipOff | paDitherOff,
                                  &OutputStream::callback,
                                  this);
  failure = start_stream(failure, stream, device);
  if (failure != paNoError) {
    throw DeviceError{fmt::format(
        "cannot open the sound output '{}' at {} samples per second: {}; choose another rate or "
        "device (a session can do without: `bimodal run ... --audio none`)",
        describe(device),
        rate.count(),
        Pa_GetErrorText(failure))};
  }
  constexpr double kNanosecondsPerSecond = 1e9;
  latency = Duration{std::llround(Pa_GetStreamInfo(stream)->outputLatency * kNanosecondsPerSecond)};
}

int OutputStream::callback(const void* /*input*/,
                           void* output,
                           unsigned long frames,
                           const PaStreamCallbackTimeInfo* times,
                           PaStreamCallbackFlags flags,
                           void* stream) noexcept {
  const auto entry = MonotonicClock{}.now();
  auto& self = *static_cast<OutputStream*>(stream);
  self.times.push({self.mixer.position(),
                   entry.time_since_epoch().count(),
                   times != nullptr ? times->currentTime : 0.0,
                   times != nullptr ? times->outputBufferDacTime : 0.0,
                   static_cast<std::int64_t>(frames)});
  self.mixer.render({static_cast<float*>(output), frames * self.channels},
                    self.channels,
                    (flags & paOutputUnderflow) != 0);
  return paContinue;
}

void OutputStream::await_clock() {
  const auto deadline = MonotonicClock{}.now() + kLongestStart;
  std::vector<CallbackTimes> first;
  std::vector<std::int64_t> frames;
  const auto enough = [&first] {
    return first.size() >= kStartReadings ||
           (first.size() >= kFewestReadings &&
            first.back().entry - first.front().entry >= kStartSpan);
  };
  while (!enough()) {
    if (MonotonicClock{}.now() > deadline) {
      throw DeviceError{
          fmt::format("cannot use the sound output '{}': it asked for only {} buffers of samples "
                      "in {} s; check "
                      "the sound server (a session can do without: `bimodal run ... --audio none`)",
                      describe(device),
                      first.size(),
                      std::chrono::duration<double>{kLongestStart}.count())};
    }
    std::this_thread::sleep_for(std::chrono::milliseconds{2});
    while (const auto reading = times.try_pop()) {
      first.push_back(told(*reading));
      frames.push_back(reading->frames);
    }
  }
  const auto verdict = judge_stream_times(first, rate);
  stream_times_plausible = verdict.plausible;
  implausible_because = verdict.reason;
  for (std::size_t i = 0; i < first.size(); ++i) note(first[i], frames[i]);
}

void OutputStream::note(const CallbackTimes& buffer, std::int64_t frames) {
  last_reading = buffer.entry;
  follower.note_buffer(output_reading(buffer, stream_times_plausible, latency), frames);
}

/// Takes what the callback has left since the last time.
void OutputStream::collect() {
  take_reports();
  while (const auto reading = times.try_pop()) note(told(*reading), reading->frames);
  follower.follow();
  if (MonotonicClock{}.now() - last_reading > kLostAfter) follower.note_loss();
}

void OutputStream::take_reports() {
  while (const auto report = mixer.next_report()) {
    if (report->kind == MixerReport::Kind::Started) {
      if (report->sound != present) continue;
      follower.note_start(report->at);
      continue;
    }
    borrowed.erase(report->sound);
    if (report->sound != present) continue;
    follower.note_end(report->underflows);
  }
}

void OutputStream::post(const MixerCommand& command) {
  if (mixer.post(command)) return;
  throw DeviceError{
      fmt::format("the sound output '{}' has stopped taking sounds; check the sound "
                  "server and start the session again",
                  describe(device))};
}

}  // namespace bimodal::runner
