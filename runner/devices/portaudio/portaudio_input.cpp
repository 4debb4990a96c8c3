#include "runner/devices/portaudio/portaudio_input.hpp"

#include <cmath>
#include <thread>

#include <fmt/format.h>
#include <portaudio.h>

#include "runner/devices/device_error.hpp"
#include "runner/devices/monotonic_clock.hpp"
#include "runner/devices/portaudio/portaudio_session.hpp"
#include "runner/devices/portaudio/portaudio_stream.hpp"
#include "runner/realtime/capture_buffer.hpp"
#include "runner/realtime/latest_ring.hpp"
#include "runner/timing/stream_times.hpp"
#include "stimuli/base/counted.hpp"

namespace bimodal::runner {

namespace {

constexpr std::size_t kBuffered = 1UL << 18U;  ///< samples: 5.4 s at 48 kHz
constexpr Duration kLongestStart = std::chrono::seconds{3};
constexpr Duration kLostAfter = std::chrono::seconds{1};
constexpr std::size_t kReadings = 1024;
constexpr std::size_t kJudged = 64;  ///< readings by which stream times are judged

}  // namespace

/// What the callback and the control side share (buffer), and what only the control side touches
/// (the rest).
struct PortaudioInput::Stream {
  explicit Stream(const PortaudioInputOptions& options);
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  Stream(Stream&&) = delete;
  Stream& operator=(Stream&&) = delete;
  ~Stream();

  /// What the callback was told, in words of 64 bits.
  struct Reading {
    std::int64_t frame;
    std::int64_t entry_ns;
    double current;
    double captured;
  };

  static int callback(const void* input,
                      void* output,
                      unsigned long frames,
                      const PaStreamCallbackTimeInfo* times,
                      PaStreamCallbackFlags flags,
                      void* stream) noexcept;

  void open();
  void await_sound();
  void close() noexcept;
  std::size_t drain(std::vector<float>* samples);
  void follow_clock();

  PortaudioSession session;
  AudioDevice device;
  Hertz rate;
  std::size_t channels = 1;  ///< of the stream
  std::size_t taken = 1;     ///< of them
  CaptureBuffer<kBuffered> buffer;
  LatestRing<Reading, kReadings> readings;
  std::int64_t delivered = 0;  ///< frames; for the callback

  PaStream* stream = nullptr;
  MonotonicClock clock;
  Instant last_sound;
  bool captures = false;
  bool gone = false;
  std::int64_t lost_before = 0;
  std::int64_t drained = 0;  ///< frames
  std::int64_t first = 0;
  std::vector<CallbackTimes> first_times;  ///< until they are judged
  bool stream_times_plausible = false;
  ClockMap map;
};

PortaudioInput::Stream::Stream(const PortaudioInputOptions& options)
    : device{choose_device(
          session.inputs(), options.device, options.is_measuring ? kMeasuring : kRecording)},
      rate{options.rate},
      taken{options.channels},
      buffer{options.channels},
      map{options.rate} {
  open();
  try {
    await_sound();
  } catch (...) {
    close();
    throw;
  }
}

PortaudioInput::Stream::~Stream() {
  if (gone) {
    session.abandon();  // PortAudio would wait for ever for a sound server that is gone
    return;
  }
  close();
}

void PortaudioInput::Stream::close() noexcept {
  const SilencedStderr quiet;
  Pa_AbortStream(stream);  // after it, the callback does not run
  Pa_CloseStream(stream);
}

void PortaudioInput::Stream::open() {
  const SilencedStderr quiet;
  PaStreamParameters parameters{};
  parameters.device = device.index;
  parameters.sampleFormat = paFloat32;
  parameters.suggestedLatency = device.safe_latency;
  const auto try_with = [&](std::size_t count) {
    channels = count;
    parameters.channelCount = static_cast<int>(count);
    return Pa_OpenStream(&stream,
                         &parameters,
                         nullptr,
                         rate.count(),
                         paFramesPerBufferUnspecified,
                         paClipOff | paDitherOff,
                         &Stream::callback,
                         this);
  };
  PaError failure = try_with(taken);
  // Some hardware has no stream of fewer channels than it has.
  if (failure == paInvalidChannelCount && static_cast<std::size_t>(device.channels) > taken) {
    failure = try_with(static_cast<std::size_t>(device.channels));
  }
  failure = start_stream(failure, stream, device);
  if (failure != paNoError) {
    throw DeviceError{fmt::format(
        "cannot open {} of the sound input '{}' at {} samples per second: {}; choose another rate "
        "or device, or fewer channels",
        counted(taken, "channel"),
        describe(device),
        rate.count(),
        Pa_GetErrorText(failure))};
  }
  last_sound = clock.now();
}

int PortaudioInput::Stream::callback(const void* input,
                                     void* /*output*/,
                                     unsigned long frames,
                                     const PaStreamCallbackTimeInfo* times,
                                     PaStreamCallbackFlags flags,
                                     void* stream) noexcept {
  if (input == nullptr) return paContinue;
  auto& self = *static_cast<Stream*>(stream);
  self.readings.push({self.delivered,
                      MonotonicClock{}.now().time_since_epoch().count(),
                      times != nullptr ? times->currentTime : 0.0,
                      times != nullptr ? times->inputBufferAdcTime : 0.0});
  self.delivered += static_cast<std::int64_t>(frames);
  self.buffer.write({static_cast<const float*>(input), frames * self.channels},
                    self.channels,
                    (flags & paInputOverflow) != 0);
  return paContinue;
}

void PortaudioInput::Stream::await_sound() {
  const auto deadline = clock.now() + kLongestStart;
  while (drain(nullptr) == 0) {
    if (clock.now() > deadline) {
      throw DeviceError{
          fmt::format("cannot use the microphone '{}': it has delivered no sound in {} s; check "
                      "it and the sound server, or choose another by --device",
                      describe(device),
                      std::chrono::duration<double>{kLongestStart}.count())};
    }
    std::this_thread::sleep_for(std::chrono::milliseconds{2});
  }
}

/// Takes what the callback has left, and returns how much that was.
std::size_t PortaudioInput::Stream::drain(std::vector<float>* samples) {
  std::size_t count = 0;
  while (const auto sample = buffer.try_pop()) {
    ++count;
    if (samples != nullptr) samples->push_back(*sample);
  }
  if (count > 0) last_sound = clock.now();
  drained += static_cast<std::int64_t>(count / taken);
  follow_clock();
  return count;
}

void PortaudioInput::Stream::follow_clock() {
  const double stated = Pa_GetStreamInfo(stream)->inputLatency;
  const Duration latency{std::llround(stated * 1e9)};
  while (const auto reading = readings.try_pop()) {
    const CallbackTimes times{
        reading->frame, Instant{Duration{reading->entry_ns}}, reading->current, reading->captured};
    if (first_times.size() < kJudged) {
      first_times.push_back(mirrored(times));
      stream_times_plausible = judge_stream_times(first_times, rate).plausible;
      continue;
    }
    map.add(input_reading(times, stream_times_plausible, latency));
  }
}

std::vector<std::string> describe_microphones() {
  std::vector<std::string> descriptions;
  const PortaudioSession session;
  for (const auto& device : session.inputs()) descriptions.push_back(describe(device));
  return descriptions;
}

PortaudioInput::PortaudioInput(const PortaudioInputOptions& options)
    : stream_{std::make_unique<Stream>(options)} {}

PortaudioInput::~PortaudioInput() = default;

void PortaudioInput::start() {
  stream_->drain(nullptr);
  stream_->first = stream_->drained;
  stream_->last_sound = stream_->clock.now();
  stream_->lost_before = stream_->buffer.lost();
  stream_->captures = true;
}

void PortaudioInput::collect(std::vector<float>& samples) {
  if (!stream_->captures) return;
  auto& stream = *stream_;
  if (stream.drain(&samples) > 0 || stream.clock.now() - stream.last_sound < kLostAfter) return;
  stream.gone = true;
  throw DeviceError{
      fmt::format("the microphone '{}' has stopped delivering sound; check it and begin again: "
                  "what was recorded is kept",
                  describe(stream.device))};
}

void PortaudioInput::stop() {
  stream_->captures = false;
}

std::int64_t PortaudioInput::lost() const {
  return stream_->buffer.lost() - stream_->lost_before;
}

std::size_t PortaudioInput::channels() const {
  return stream_->taken;
}

std::int64_t PortaudioInput::first_frame() const {
  return stream_->first;
}

std::optional<DeviceClock> PortaudioInput::clock() {
  stream_->follow_clock();
  const auto& fit = stream_->map.fit();
  if (!fit) return std::nullopt;
  return DeviceClock{*fit, stream_->map.jumps(), stream_->map.latest_jump()};
}

Hertz PortaudioInput::rate() const {
  return stream_->rate;
}

std::string PortaudioInput::kind() const {
  return "portaudio";
}

std::string PortaudioInput::description() const {
  return fmt::format(
      "{}; {}, stream of {} samples per second on {} channels, input latency {:.2f} "
      "ms",
      Pa_GetVersionInfo()->versionText,
      describe(stream_->device),
      stream_->rate.count(),
      stream_->channels,
      Pa_GetStreamInfo(stream_->stream)->inputLatency * 1e3);
}

}  // namespace bimodal::runner
