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
constexpr Duration kSettling = std::chrono::milliseconds{100};
constexpr std::int64_t kBuffersToConfirm = 9;  ///< a jump: as many as a ClockMap asks for, and one
constexpr Duration kStartSpan = std::chrono::milliseconds{500};
constexpr std::size_t kFewestReadings = 16;
constexpr std::size_t kStartReadings = 64;  ///< suffice, however short their span

}  // namespace

OutputStream::OutputStream(const PortaudioOptions& options)
    : device{choose_device(session.devices(), options.device)},
      rate{options.rate},
      channels{static_cast<std::size_t>(
          choose_channels(device, options.channels, options.rate.count()))},
      mixer{nearest_sample(kFade, options.rate).count()},
      clock{options.rate} {
  playback.finished = true;
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
  if (playback.lost) {
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
        "device, or run without sound by --audio none",
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
  const auto enough = [this] {
    return first_times.size() >= kStartReadings ||
           (first_times.size() >= kFewestReadings &&
            first_times.back().entry - first_times.front().entry >= kStartSpan);
  };
  while (!enough()) {
    if (MonotonicClock{}.now() > deadline) {
      throw DeviceError{
          fmt::format("cannot use the sound output '{}': it asked for only {} buffers of samples "
                      "in {} s; check "
                      "the sound server, or run without sound by --audio none",
                      describe(device),
                      first_times.size(),
                      std::chrono::duration<double>{kLongestStart}.count())};
    }
    std::this_thread::sleep_for(std::chrono::milliseconds{2});
    while (const auto reading = times.try_pop()) {
      first_times.push_back({reading->sample,
                             Instant{Duration{reading->entry_ns}},
                             reading->current,
                             reading->output});
      largest_buffer = std::max(largest_buffer, reading->frames);
    }
  }
  const auto verdict = judge_stream_times(first_times, rate);
  stream_times_plausible = verdict.plausible;
  implausible_because = verdict.reason;
  for (const auto& times_of_one : first_times) {
    clock.add(output_reading(times_of_one, stream_times_plausible, latency));
  }
  last_reading = first_times.back().entry;
}

void OutputStream::add(const Reading& reading) {
  largest_buffer = std::max(largest_buffer, reading.frames);
  last_reading = Instant{Duration{reading.entry_ns}};
  last_sample = reading.sample;
  const auto jumps = clock.jumps();
  clock.add(output_reading({reading.sample, last_reading, reading.current, reading.output},
                           stream_times_plausible,
                           latency));
  if (clock.jumps() == jumps || !started) return;
  const auto heard = *clock.latest_jump() - playback.start_sample;
  playback.jumped = playback.jumped || (heard > head && heard < length);
}

/// The onset follows the clock until a tenth of a second has been played and no jump before it can
/// become known any more, or until a jump comes: what happens to the stream later moves the clock
/// but not what has been heard.
void OutputStream::follow_onset() {
  if (!started || onset_settled) return;
  const auto first_heard = playback.start_sample + head;
  onset_settled = clock.latest_jump() > first_heard;
  if (onset_settled) return;
  playback.onset = clock.fit()->instant_of(playback.start_sample);
  const auto settling =
      std::max(nearest_sample(kSettling, rate).count(), kBuffersToConfirm * largest_buffer);
  onset_settled = last_sample >= first_heard + settling;
}

/// Takes what the callback has left since the last time.
void OutputStream::collect() {
  take_reports();
  while (const auto reading = times.try_pop()) {
    add(*reading);
  }
  follow_onset();
  const auto end = playback.start_sample + length;
  playback.known =
      playback.finished && (!started || last_sample >= end + kBuffersToConfirm * largest_buffer);
  if (MonotonicClock{}.now() - last_reading > kLostAfter) {
    playback.lost = playback.finished = playback.known = true;
  }
}

void OutputStream::take_reports() {
  while (const auto report = mixer.next_report()) {
    if (report->kind == MixerReport::Kind::Started) {
      if (report->sound != present) continue;
      started = true;
      playback.start_sample = report->at - head;
      onset_settled = false;
      playback.onset = clock.fit()->instant_of(playback.start_sample);
      continue;
    }
    borrowed.erase(report->sound);
    if (report->sound != present) continue;
    playback.finished = true;
    playback.underflows = report->underflows;
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
