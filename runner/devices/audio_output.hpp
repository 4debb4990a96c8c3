#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/realtime/channel_set.hpp"
#include "runner/timing/clock_map.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// What other equipment is to hear with a sound: its first sample leaves with the sound's sample
/// `start`, however late that is.
struct Marker {
  std::shared_ptr<const std::vector<float>> samples;
  std::int64_t start = 0;  ///< >= 0
  ChannelSet channels;
};

/// Samples to be played, kept alive by the output until they have been. The same on each of its
/// channels; of these, an output leaves out those that it does not have.
struct Sound {
  Hertz rate{48'000};
  std::shared_ptr<const std::vector<float>> samples;
  ChannelSet channels = kBothEars;
  std::optional<Marker> marker{};
  /// So many samples of exact silence come first, in the marker too: until they are over the sound
  /// can still be moved.
  std::int64_t silent_head = 0;
};

/// How many samples of exact silence `sound` begins with; all but one of a silent sound.
[[nodiscard]] std::int64_t count_silent_head(const Sound& sound);

/// To the nearest nanosecond, the marker included.
[[nodiscard]] Duration duration(const Sound& sound);

/// Throws Error if the sound has no samples or another rate than the output.
void require_playable(const Sound& sound, Hertz output_rate);

/// What became of the last scheduled sound.
struct Playback {
  std::optional<Instant>
      onset;  ///< first sample at the output, on the session clock; absent: not yet
  std::int64_t start_sample = 0;  ///< stream sample at which it started
  std::string_view source;        ///< "stream_time", "callback_time", "predicted", "none"
  bool finished = false;          ///< or stopped, or none was scheduled, or the device is lost
  bool lost = false;              ///< the device has stopped asking for samples
  std::int64_t underflows = 0;    ///< during this sound
  bool jumped = false;            ///< the device's clock jumped while it was heard
  bool known = true;              ///< nothing more can become known of it
};

/// One always-open stream into which sounds are placed at computed samples. Used by one thread; the
/// device's own thread pulls the samples.
class AudioOutput {
 public:
  AudioOutput() = default;
  AudioOutput(const AudioOutput&) = delete;
  AudioOutput& operator=(const AudioOutput&) = delete;
  AudioOutput(AudioOutput&&) = delete;
  AudioOutput& operator=(AudioOutput&&) = delete;
  virtual ~AudioOutput() = default;

  /// Starts `sound` so that its first sample is heard at `onset`. If `onset` is closer than
  /// lead_time() it starts late, and Playback says when. Replaces a sound not yet finished.
  virtual void schedule(const Sound& sound, Instant onset) = 0;

  /// Moves the scheduled sound, so that its first sample is heard at `onset`, if nothing but its
  /// silent head has been played. To be called as far ahead of the head's end as schedule().
  virtual void move(Instant onset) = 0;

  /// Fades the present sound out within 5 ms.
  virtual void stop() = 0;

  [[nodiscard]] virtual Playback playback() = 0;

  /// Absent where nothing was measured.
  [[nodiscard]] virtual std::optional<DeviceClock> clock() { return std::nullopt; }

  /// How far ahead schedule() must be called.
  [[nodiscard]] virtual Duration lead_time() const = 0;

  [[nodiscard]] virtual Hertz rate() const = 0;
  [[nodiscard]] virtual std::string kind() const = 0;  ///< "portaudio", "none", "simulated"

  /// By which the device is known again, whatever else is connected.
  [[nodiscard]] virtual std::string device_name() const { return kind(); }

  [[nodiscard]] virtual std::string description() const = 0;  ///< host API, device, latency
  [[nodiscard]] virtual std::string_view time_source() const = 0;
};

}  // namespace bimodal::runner
