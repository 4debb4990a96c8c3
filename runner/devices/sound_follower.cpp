#include "runner/devices/sound_follower.hpp"

#include <algorithm>

namespace bimodal::runner {

namespace {

constexpr Duration kSettling = std::chrono::milliseconds{100};
constexpr std::int64_t kBuffersToConfirm = 9;  ///< a jump: as many as a ClockMap asks for, and one

}  // namespace

SoundFollower::SoundFollower(Hertz rate) : rate_{rate}, clock_{rate} {
  playback_.finished = true;
}

void SoundFollower::note_buffer(const ClockPair& first, std::int64_t frames) {
  largest_buffer_ = std::max(largest_buffer_, frames);
  last_sample_ = first.sample;
  const auto jumps = clock_.jumps();
  clock_.add(first);
  if (clock_.jumps() == jumps || !started_) return;
  const auto heard = *clock_.latest_jump() - playback_.start_sample;
  playback_.jumped = playback_.jumped || (heard > head_ && heard < length_);
}

void SoundFollower::expect(std::int64_t head, std::int64_t length) {
  head_ = head;
  length_ = length;
  started_ = false;
  playback_ = Playback{.known = false};
}

void SoundFollower::note_start(std::int64_t at) {
  started_ = true;
  onset_settled_ = false;
  playback_.start_sample = at - head_;
  if (const auto& fit = clock_.fit()) playback_.onset = fit->instant_of(playback_.start_sample);
}

void SoundFollower::note_end(std::int64_t underflows) {
  playback_.finished = true;
  playback_.underflows = underflows;
}

void SoundFollower::note_loss() {
  playback_.lost = playback_.finished = playback_.known = true;
}

void SoundFollower::follow() {
  if (started_ && !onset_settled_) follow_onset();
  if (playback_.lost) return;
  const auto end = playback_.start_sample + length_;
  playback_.known = playback_.finished && (!started_ || last_sample_ >= end + confirmation());
}

void SoundFollower::follow_onset() {
  const auto first_heard = playback_.start_sample + head_;
  onset_settled_ = clock_.latest_jump() > first_heard;
  if (onset_settled_) return;
  if (const auto& fit = clock_.fit()) playback_.onset = fit->instant_of(playback_.start_sample);
  const auto settling = std::max(nearest_sample(kSettling, rate_).count(), confirmation());
  onset_settled_ = last_sample_ >= first_heard + settling;
}

std::int64_t SoundFollower::confirmation() const {
  return kBuffersToConfirm * largest_buffer_;
}

}  // namespace bimodal::runner
