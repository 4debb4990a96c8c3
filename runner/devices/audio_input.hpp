#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runner/timing/clock_map.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// A microphone or a line input. The stream is always open; a capture is a stretch of it. Used by
/// one thread; the device's own thread delivers the samples.
class AudioInput {
 public:
  AudioInput() = default;
  AudioInput(const AudioInput&) = delete;
  AudioInput& operator=(const AudioInput&) = delete;
  AudioInput(AudioInput&&) = delete;
  AudioInput& operator=(AudioInput&&) = delete;
  virtual ~AudioInput() = default;

  /// Begins a capture; what the microphone heard before is forgotten.
  virtual void start() = 0;

  /// Appends what has been captured since the last call to `samples` (full scale is 1, frame after
  /// frame of channels() samples each); nothing
  /// unless a capture goes on. To be called at least every second, or samples are lost. Throws
  /// DeviceError if the device has delivered nothing for a second.
  virtual void collect(std::vector<float>& samples) = 0;

  /// Ends the capture; what was not collected is forgotten.
  virtual void stop() = 0;

  /// Samples that were lost since start(), at least: 0 means that there are no gaps.
  [[nodiscard]] virtual std::int64_t lost() const = 0;

  [[nodiscard]] virtual std::size_t channels() const { return 1; }

  /// Where in the stream the capture began, in frames; meaningful as long as nothing is lost.
  [[nodiscard]] virtual std::int64_t first_frame() const { return 0; }

  /// When the stream's frames were captured; absent where nothing is measured.
  [[nodiscard]] virtual std::optional<DeviceClock> clock() { return std::nullopt; }

  [[nodiscard]] virtual Hertz rate() const = 0;
  [[nodiscard]] virtual std::string kind() const = 0;         ///< "portaudio", "simulated"
  [[nodiscard]] virtual std::string description() const = 0;  ///< host API, device, latency
};

}  // namespace bimodal::runner
