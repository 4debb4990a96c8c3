#include "runner/devices/portaudio/portaudio_output.hpp"

#include <cmath>

#include <fmt/format.h>
#include <portaudio.h>

#include "runner/devices/device_error.hpp"
#include "runner/devices/portaudio/output_name.hpp"
#include "runner/devices/portaudio/output_stream.hpp"
#include "stimuli/base/milliseconds.hpp"

namespace bimodal::runner {

namespace {

constexpr Duration kMargin = std::chrono::milliseconds{5};

MixerMarker mixer_marker(const Marker& marker) {
  return {.samples = marker.samples->data(),
          .length = static_cast<std::int64_t>(marker.samples->size()),
          .start = marker.start,
          .channels = marker.channels};
}

}  // namespace

std::vector<std::string> describe_audio_devices() {
  std::vector<std::string> descriptions;
  const PortaudioSession session;
  for (const auto& device : session.devices()) descriptions.push_back(describe(device));
  return descriptions;
}

PortaudioOutput::PortaudioOutput(const PortaudioOptions& options)
    : stream_{std::make_unique<OutputStream>(options)} {}

PortaudioOutput::~PortaudioOutput() = default;

void PortaudioOutput::schedule(const Sound& sound, Instant onset) {
  require_playable(sound, stream_->rate);
  auto& stream = *stream_;
  stream.collect();
  if (stream.follower.playback().lost) {
    throw SoundLost{
        fmt::format("the sound output '{}' has stopped asking for samples; check the device and "
                    "the sound server",
                    describe(stream.device))};
  }
  const auto number = stream.present + 1;
  const auto head = sound.silent_head;
  const auto length = static_cast<std::int64_t>(sound.samples->size());
  stream.start = stream.follower.clock().fit()->sample_at(onset) + head;
  auto marker = sound.marker ? mixer_marker(*sound.marker) : MixerMarker{};
  if (sound.marker) marker.start -= head;
  stream.post({.kind = MixerCommand::Kind::Start,
               .sound = number,
               .samples = sound.samples->data() + head,
               .length = length - head,
               .start = stream.start,
               .channels = sound.channels,
               .marker = marker});
  stream.borrowed[number] = sound;
  stream.present = number;
  stream.follower.expect(head, length);
}

void PortaudioOutput::move(Instant onset) {
  auto& stream = *stream_;
  stream.collect();
  auto& follower = stream.follower;
  if (follower.started() || follower.playback().finished) return;
  const auto start = follower.clock().fit()->sample_at(onset) + follower.head();
  if (start == stream.start) return;
  stream.start = start;
  stream.post({.kind = MixerCommand::Kind::Move, .sound = stream.present, .start = start});
}

void PortaudioOutput::stop() {
  stream_->collect();
  if (!stream_->follower.playback().finished) {
    stream_->post({.kind = MixerCommand::Kind::Stop});
  }
}

Playback PortaudioOutput::playback() {
  stream_->collect();
  auto playback = stream_->follower.playback();
  playback.source = time_source();
  return playback;
}

Duration PortaudioOutput::lead_time() const {
  const double buffers = 2.0 * static_cast<double>(stream_->follower.largest_buffer());
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
  auto text = fmt::format(
      "{}; {}, stream of {} samples per second on {} channels, output latency "
      "{:.2f} ms, buffers of up to {} frames",
      Pa_GetVersionInfo()->versionText,
      describe(stream_->device),
      stream_->rate.count(),
      stream_->channels,
      milliseconds(stream_->latency),
      stream_->follower.largest_buffer());
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
  auto& clock = stream_->follower.clock();
  return DeviceClock{*clock.fit(), clock.jumps(), clock.latest_jump()};
}

}  // namespace bimodal::runner
