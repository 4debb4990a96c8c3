#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "stimuli/audio/biquad.hpp"
#include "stimuli/audio/clip.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

/// A high-pass of second order that keeps what a table, a fan or an offset adds below the voice out
/// of levels.
class RumbleFilter {
 public:
  static constexpr Hertz kEdge{80};

  explicit RumbleFilter(Hertz rate) : filter_{Biquad::high_pass(kEdge, rate)} {}

  /// The next sample of the filtered sound; a constant offset is gone from the first sample on.
  double operator()(float sample);

 private:
  Biquad filter_;
  bool primed_ = false;
};

/// How loud a room is when nobody speaks: the median level of frames of 10 ms without rumble, so
/// that a single click does not count. dB re full scale (an RMS of 1), at least -120; that too for
/// less than one frame.
[[nodiscard]] Decibels room_level(const Clip& room);

/// Tells speech from the room while a recording goes on: samples go in as they come, and at any
/// time it is known from when to when somebody has spoken so far. For one thread.
///
/// Levels are taken of frames of 10 ms without rumble. A run of frames that stay 8 dB above the
/// room is speech if one of them is 15 dB above it and it lasts for 50 ms (20 ms once there is
/// speech: the release of a final stop); shorter ones are clicks. From the first run to the last
/// one everything is one stretch, pauses included. Where a loud sound breaks off, the end is up to
/// a frame late: the filter rings. A room below -75 dB FS counts as that loud.
class SpeechDetector {
 public:
  SpeechDetector(Hertz rate, Decibels room);

  void feed(std::span<const float> samples);

  /// From the beginning of speech to its end so far, in whole frames; absent: nobody has spoken.
  [[nodiscard]] std::optional<SpeechInterval> speech() const { return speech_; }

  /// Of all samples, in whole frames.
  [[nodiscard]] Duration heard() const;

  /// Since the end of speech; absent: nobody has spoken.
  [[nodiscard]] std::optional<Duration> silence() const;

 private:
  void take_frame(double level);

  RumbleFilter filter_;
  double rate_;
  double opens_;  ///< dB FS
  double stays_;
  std::size_t samples_ = 0;
  std::size_t frame_end_;  ///< the sample with which the next frame begins
  std::size_t frame_begin_ = 0;
  double sum_ = 0.0;
  std::size_t frames_ = 0;
  std::optional<std::size_t> run_;  ///< first frame of the present run
  bool opened_ = false;             ///< the run has been loud enough
  std::optional<SpeechInterval> speech_;
};

}  // namespace bimodal
