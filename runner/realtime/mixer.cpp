#include "runner/realtime/mixer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bimodal::runner {

namespace {

/// Adds a sample to some of the channels of one frame of the stream.
void add_sample(std::span<float> frame, ChannelSet channels, float sample) noexcept {
  for (std::size_t channel = 0; channel < frame.size(); ++channel) {
    if (channels.has(channel)) frame[channel] += sample;
  }
}

/// Of the sound or of its marker, whichever ends later.
std::int64_t whole_length(const MixerCommand& command) noexcept {
  const auto& marker = command.marker;
  return marker.length == 0 ? command.length
                            : std::max(command.length, marker.start + marker.length);
}

}  // namespace

void Mixer::render(std::span<float> output, std::size_t channels, bool underflow) noexcept {
  std::ranges::fill(output, 0.0F);
  take_commands();
  for (auto& voice : voices_) {
    if (!voice.used) continue;
    if (underflow && voice.started && !voice.finished) ++voice.underflows;
    if (!voice.finished) add(voice, output, channels);
    report(voice);
  }
  position_ += static_cast<std::int64_t>(output.size() / channels);
}

void Mixer::take_commands() noexcept {
  if (waiting_) {
    const auto command = *waiting_;
    waiting_.reset();
    begin(command);
  }
  while (!waiting_) {
    const auto command = commands_.try_pop();
    if (!command) return;
    if (command->kind == MixerCommand::Kind::Move) {
      move(*command);
      continue;
    }
    release_all();
    if (command->kind == MixerCommand::Kind::Start) begin(*command);
  }
}

void Mixer::move(const MixerCommand& command) noexcept {
  for (auto& voice : voices_) {
    const bool is_meant = voice.used && voice.command.sound == command.sound;
    if (is_meant && !voice.started && !voice.finished) voice.command.start = command.start;
  }
}

void Mixer::release_all() noexcept {
  for (auto& voice : voices_) {
    if (!voice.used || voice.finished || voice.fade_left >= 0) continue;
    voice.fade_left = fade_length_;
    if (!voice.started) {
      voice.finished = true;
      voice.finished_at = position_;
    }
  }
}

void Mixer::begin(const MixerCommand& command) noexcept {
  auto* const voice = std::ranges::find(voices_, false, &Voice::used);
  if (voice == voices_.end()) {
    waiting_ = command;
    return;
  }
  *voice = Voice{};
  voice->used = true;
  voice->command = command;
}

void Mixer::add(Voice& voice, std::span<float> output, std::size_t channels) const noexcept {
  const auto frames = static_cast<std::int64_t>(output.size() / channels);
  std::int64_t frame = 0;
  if (!voice.started) {
    frame = std::max<std::int64_t>(voice.command.start - position_, 0);
    if (frame >= frames) return;
    voice.started = true;
    voice.started_at = position_ + frame;
  }
  const auto& command = voice.command;
  const auto length = whole_length(command);
  while (frame < frames && voice.next < length && voice.fade_left != 0) {
    float gain = 1.0F;
    if (voice.fade_left > 0) {
      const double rest =
          static_cast<double>(voice.fade_left--) / static_cast<double>(fade_length_);
      gain = static_cast<float>(0.5 * (1.0 - std::cos(std::numbers::pi * rest)));
    }
    const auto at = voice.next++;
    const auto heard = output.subspan(static_cast<std::size_t>(frame++) * channels, channels);
    if (at < command.length) add_sample(heard, command.channels, gain * command.samples[at]);
    const auto in_marker = at - command.marker.start;
    if (in_marker >= 0 && in_marker < command.marker.length) {
      add_sample(heard, command.marker.channels, gain * command.marker.samples[in_marker]);
    }
  }
  if (voice.next == length || voice.fade_left == 0) {
    voice.finished = true;
    voice.finished_at = position_ + frame;
  }
}

void Mixer::report(Voice& voice) noexcept {
  if (voice.started && !voice.started_reported) {
    const MixerReport started{
        MixerReport::Kind::Started, voice.command.sound, voice.started_at, voice.underflows};
    if (!reports_.try_push(started)) return;
    voice.started_reported = true;
  }
  if (!voice.finished) return;
  const MixerReport finished{
      MixerReport::Kind::Finished, voice.command.sound, voice.finished_at, voice.underflows};
  if (reports_.try_push(finished)) voice.used = false;
}

}  // namespace bimodal::runner
