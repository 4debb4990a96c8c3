#include "runner/devices/portaudio/portaudio_output.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <ctime>
#include <map>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <portaudio.h>

#include "runner/devices/device_error.hpp"
#include "runner/devices/portaudio/output_channels.hpp"
#include "runner/devices/portaudio/output_name.hpp"
#include "runner/devices/portaudio/portaudio_session.hpp"
#include "runner/devices/portaudio/portaudio_stream.hpp"
#include "runner/realtime/latest_ring.hpp"
#include "runner/realtime/mixer.hpp"
#include "runner/timing/stream_times.hpp"

namespace bimodal::runner {

namespace {

constexpr Duration kFade = std::chrono::milliseconds{5};
constexpr Duration kLongestStart = std::chrono::seconds{3};
constexpr Duration kLostAfter = std::chrono::seconds{1};
constexpr Duration kMargin = std::chrono::milliseconds{5};
constexpr Duration kSettling = std::chrono::milliseconds{100};
constexpr Duration kStartSpan = std::chrono::milliseconds{500};
constexpr std::size_t kFewestReadings = 16;
constexpr std::size_t kStartReadings = 64;  ///< suffice, however short their span
constexpr std::size_t kRing = 1024;

/// CLOCK_MONOTONIC. Safe in the audio callback: no lock, no system call (vDSO).
Instant monotonic_now() noexcept {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return Instant{std::chrono::seconds{time.tv_sec} + std::chrono::nanoseconds{time.tv_nsec}};
}

MixerMarker mixer_marker(const Marker& marker) {
  return {.samples = marker.samples->data(),
          .length = static_cast<std::int64_t>(marker.samples->size()),
          .start = marker.start,
          .channels = marker.channels};
}

}  // namespace

/// What the callback and the control side share (mixer_, times_), and what only the control side
/// touches (the rest).
struct PortaudioOutput::Stream {
  explicit Stream(const PortaudioOptions& options);
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  Stream(Stream&&) = delete;
  Stream& operator=(Stream&&) = delete;
  ~Stream();

  struct Reading {
    std::int64_t sample;
    std::int64_t entry_ns;
    double current;
    double output;
    std::int64_t frames;
  };

  static int callback(const void* input,
                      void* output,
                      unsigned long frames,
                      const PaStreamCallbackTimeInfo* times,
                      PaStreamCallbackFlags flags,
                      void* stream) noexcept;

  void open(const PortaudioOptions& options);
  void await_clock();
  void collect();
  void add(const Reading& reading);
  void follow_onset(std::int64_t sample);
  void take_reports();
  void post(const MixerCommand& command);

  PortaudioSession session;
  AudioDevice device;
  Hertz rate;
  std::size_t channels;
  Mixer mixer;
  LatestRing<Reading, kRing> times;

  PaStream* stream = nullptr;
  Duration latency{};               ///< as the host states it
  std::int64_t largest_buffer = 0;  ///< frames
  bool stream_times_plausible = false;
  std::string_view implausible_because;
  std::vector<CallbackTimes> first_times;  ///< until the verdict
  ClockMap clock;
  Instant last_reading;

  std::map<std::uint64_t, Sound> borrowed;
  std::uint64_t present = 0;  ///< number of the last scheduled sound; 0: none
  std::int64_t start = 0;     ///< stream sample for which it is scheduled, without its silent head
  std::int64_t head = 0;      ///< samples of that
  Playback playback;
  bool started = false;
  bool onset_settled = false;
};

PortaudioOutput::Stream::Stream(const PortaudioOptions& options)
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

PortaudioOutput::Stream::~Stream() {
  if (playback.lost) {
    session.abandon();  // PortAudio would wait for ever for a sound server that is gone
    return;
  }
  const SilencedStderr quiet;
  Pa_AbortStream(stream);  // after it, the callback does not run
  Pa_CloseStream(stream);
}

void PortaudioOutput::Stream::open(const PortaudioOptions& options) {
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
                                  &Stream::callback,
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

int PortaudioOutput::Stream::callback(const void* /*input*/,
                                      void* output,
                                      unsigned long frames,
                                      const PaStreamCallbackTimeInfo* times,
                                      PaStreamCallbackFlags flags,
                                      void* stream) noexcept {
  const auto entry = monotonic_now();
  auto& self = *static_cast<Stream*>(stream);
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

void PortaudioOutput::Stream::await_clock() {
  const auto deadline = monotonic_now() + kLongestStart;
  const auto enough = [this] {
    return first_times.size() >= kStartReadings ||
           (first_times.size() >= kFewestReadings &&
            first_times.back().entry - first_times.front().entry >= kStartSpan);
  };
  while (!enough()) {
    if (monotonic_now() > deadline) {
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

void PortaudioOutput::Stream::add(const Reading& reading) {
  largest_buffer = std::max(largest_buffer, reading.frames);
  last_reading = Instant{Duration{reading.entry_ns}};
  clock.add(output_reading({reading.sample, last_reading, reading.current, reading.output},
                           stream_times_plausible,
                           latency));
}

/// The onset follows the clock until a tenth of a second has been played. What happens to the
/// stream later, such as a lost buffer, moves the clock but not what has been heard.
void PortaudioOutput::Stream::follow_onset(std::int64_t sample) {
  if (!started || onset_settled) return;
  playback.onset = clock.fit()->instant_of(playback.start_sample);
  onset_settled = sample >= playback.start_sample + head + nearest_sample(kSettling, rate).count();
}

/// Takes what the callback has left since the last time.
void PortaudioOutput::Stream::collect() {
  take_reports();
  while (const auto reading = times.try_pop()) {
    add(*reading);
    follow_onset(reading->sample);
  }
  if (monotonic_now() - last_reading > kLostAfter) playback.lost = playback.finished = true;
}

void PortaudioOutput::Stream::take_reports() {
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

void PortaudioOutput::Stream::post(const MixerCommand& command) {
  if (mixer.post(command)) return;
  throw DeviceError{
      fmt::format("the sound output '{}' has stopped taking sounds; check the sound "
                  "server and start the session again",
                  describe(device))};
}

std::vector<std::string> describe_audio_devices() {
  std::vector<std::string> descriptions;
  const PortaudioSession session;
  for (const auto& device : session.devices()) descriptions.push_back(describe(device));
  return descriptions;
}

PortaudioOutput::PortaudioOutput(const PortaudioOptions& options)
    : stream_{std::make_unique<Stream>(options)} {}

PortaudioOutput::~PortaudioOutput() = default;

void PortaudioOutput::schedule(const Sound& sound, Instant onset) {
  require_playable(sound, stream_->rate);
  auto& stream = *stream_;
  stream.collect();
  if (stream.playback.lost) {
    throw SoundLost{fmt::format(
        "the sound output '{}' has stopped asking for samples; check it and go on by `bimodal run "
        "... --resume`",
        describe(stream.device))};
  }
  const auto number = stream.present + 1;
  stream.head = sound.silent_head;
  stream.start = stream.clock.fit()->sample_at(onset) + stream.head;
  auto marker = sound.marker ? mixer_marker(*sound.marker) : MixerMarker{};
  if (sound.marker) marker.start -= stream.head;
  stream.post({.kind = MixerCommand::Kind::Start,
               .sound = number,
               .samples = sound.samples->data() + stream.head,
               .length = static_cast<std::int64_t>(sound.samples->size()) - stream.head,
               .start = stream.start,
               .channels = sound.channels,
               .marker = marker});
  stream.borrowed[number] = sound;
  stream.present = number;
  stream.started = false;
  stream.playback = Playback{};
}

void PortaudioOutput::move(Instant onset) {
  auto& stream = *stream_;
  stream.collect();
  if (stream.started || stream.playback.finished) return;
  const auto start = stream.clock.fit()->sample_at(onset) + stream.head;
  if (start == stream.start) return;
  stream.start = start;
  stream.post({.kind = MixerCommand::Kind::Move, .sound = stream.present, .start = start});
}

void PortaudioOutput::stop() {
  stream_->collect();
  if (!stream_->playback.finished) {
    stream_->post({.kind = MixerCommand::Kind::Stop});
  }
}

Playback PortaudioOutput::playback() {
  stream_->collect();
  auto playback = stream_->playback;
  playback.source = time_source();
  return playback;
}

Duration PortaudioOutput::lead_time() const {
  const double buffers = 2.0 * static_cast<double>(stream_->largest_buffer);
  constexpr double kNanosecondsPerSecond = 1e9;
  const Duration two_buffers{std::llround(buffers / stream_->rate.count() * kNanosecondsPerSecond)};
  return stream_->latency + two_buffers + kMargin;
}

Hertz PortaudioOutput::rate() const {
  return stream_->rate;
}

std::string PortaudioOutput::kind() const {
  return "portaudio";
}

std::string PortaudioOutput::device_name() const {
  return lasting_name(stream_->device);
}

std::string PortaudioOutput::description() const {
  const auto milliseconds = [](Duration duration) {
    return std::chrono::duration<double, std::milli>{duration}.count();
  };
  auto text = fmt::format(
      "{}; {}, stream of {} samples per second on {} channels, output latency "
      "{:.2f} ms, buffers of up to {} frames",
      Pa_GetVersionInfo()->versionText,
      describe(stream_->device),
      stream_->rate.count(),
      stream_->channels,
      milliseconds(stream_->latency),
      stream_->largest_buffer);
  if (!stream_->stream_times_plausible) {
    text += fmt::format("; stream times not used: {}", stream_->implausible_because);
  }
  return text;
}

std::string_view PortaudioOutput::time_source() const {
  return stream_->stream_times_plausible ? "stream_time" : "callback_time";
}

std::optional<DeviceClock> PortaudioOutput::clock() {
  stream_->collect();
  return DeviceClock{*stream_->clock.fit(), stream_->clock.jumps()};
}

}  // namespace bimodal::runner
