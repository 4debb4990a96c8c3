#include "runner/devices/silent/silent_audio.hpp"

#include <algorithm>

namespace bimodal::runner {

SilentAudio::SilentAudio(const Clock& clock, Hertz rate) : clock_{clock}, rate_{rate} {}

void SilentAudio::schedule(const Sound& sound, Instant onset) {
  require_playable(sound, rate_);
  length_ = duration(sound);
  end_ = std::max(onset, clock_.now()) + length_;
}

void SilentAudio::move(Instant onset) {
  const auto now = clock_.now();
  if (end_ && now < *end_ - length_) end_ = std::max(onset, now) + length_;
}

void SilentAudio::stop() {
  end_.reset();
}

Playback SilentAudio::playback() {
  Playback playback;
  playback.source = time_source();
  playback.finished = !end_ || clock_.now() >= *end_;
  return playback;
}

}  // namespace bimodal::runner
