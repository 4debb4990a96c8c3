#pragma once

#include <cstdint>

#include "runner/devices/audio_output.hpp"
#include "runner/timing/clock_map.hpp"

namespace bimodal::runner {

/// Follows one sound after the other through the stream of an output: when it was heard, by the
/// stream's clock, and whether that jumped meanwhile. Used by one thread. Allocates nothing after
/// construction.
class SoundFollower {
 public:
  explicit SoundFollower(Hertz rate);

  /// The device asked for so many frames, of which `first` says when the first is at the output.
  void note_buffer(const ClockPair& first, std::int64_t frames);

  /// A sound of `length` samples is on its way, of which the first `head` are silent and not
  /// played. The one before is forgotten.
  void expect(std::int64_t head, std::int64_t length);

  /// Its first sample after the head was the stream's sample `at`.
  void note_start(std::int64_t at);

  /// It has been played, or stopped.
  void note_end(std::int64_t underflows);

  /// The device does not ask for samples any more.
  void note_loss();

  /// Draws conclusions from what was noted. The onset follows the clock until a tenth of a second
  /// has been played and no jump before it can become known any more, or until a jump comes: what
  /// happens to the stream later moves the clock but not what has been heard.
  void follow();

  /// Of the expected sound, as of the last follow(); `source` is left empty.
  [[nodiscard]] const Playback& playback() const { return playback_; }

  [[nodiscard]] bool started() const { return started_; }

  [[nodiscard]] std::int64_t head() const { return head_; }

  /// Frames, of those noted.
  [[nodiscard]] std::int64_t largest_buffer() const { return largest_buffer_; }

  [[nodiscard]] ClockMap& clock() { return clock_; }

 private:
  void follow_onset();
  /// Samples after which a jump before them would have been confirmed.
  [[nodiscard]] std::int64_t confirmation() const;

  Hertz rate_;
  ClockMap clock_;
  std::int64_t largest_buffer_ = 0;
  std::int64_t last_sample_ = 0;  ///< of the stream, that was noted
  std::int64_t head_ = 0;
  std::int64_t length_ = 0;  ///< with the head
  Playback playback_;
  bool started_ = false;
  bool onset_settled_ = false;
};

}  // namespace bimodal::runner
