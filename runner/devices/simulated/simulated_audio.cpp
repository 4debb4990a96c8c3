#include "runner/devices/simulated/simulated_audio.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace bimodal::runner {

namespace {

constexpr Duration kFade = std::chrono::milliseconds{5};

}  // namespace

SimulatedAudio::SimulatedAudio(const Clock& clock, Hertz rate) : clock_{clock}, rate_{rate} {}

void SimulatedAudio::schedule(const Sound& sound, Instant onset) {
  require_playable(sound, rate_);
  const auto start = std::max(onset, clock_.now());
  sound_ = Span{start, start + duration(sound)};
}

void SimulatedAudio::move(Instant onset) {
  const auto now = clock_.now();
  if (!sound_ || now >= sound_->start) return;
  const auto length = sound_->end - sound_->start;
  const auto start = std::max(onset, now);
  sound_ = Span{start, start + length};
}

void SimulatedAudio::stop() {
  if (!sound_) return;
  const auto now = clock_.now();
  if (sound_->start > now) {
    sound_.reset();
  } else {
    sound_->end = std::min(sound_->end, now + kFade);
  }
}

Playback SimulatedAudio::playback() {
  Playback playback;
  playback.source = time_source();
  const auto now = clock_.now();
  if (!sound_) {
    playback.finished = true;
    return playback;
  }
  if (now < sound_->start) return playback;
  playback.onset = sound_->start;
  playback.start_sample = nearest_sample(sound_->start.time_since_epoch(), rate_).count();
  playback.finished = now >= sound_->end;
  return playback;
}

std::string SimulatedAudio::description() const {
  return fmt::format("simulated, {} samples per second, virtual time", rate_.count());
}

}  // namespace bimodal::runner
