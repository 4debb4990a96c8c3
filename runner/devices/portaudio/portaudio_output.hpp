#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runner/devices/audio_output.hpp"
#include "runner/timing/clock_map.hpp"

namespace bimodal::runner {

struct OutputStream;

struct PortaudioOptions {
  std::string device;  ///< index, or part of a name as describe_audio_devices() prints it; empty:
                       ///< the default device
  Hertz rate{48'000};
  unsigned long buffer = 0;  ///< frames per callback; 0: what the device prefers
  int channels = 0;  ///< that must be there; 0: the first two, or the only one of the device
};

/// One line per device with outputs: "2: system (JACK Audio Connection Kit), 2 channels, 48000 per
/// second", the default marked.
[[nodiscard]] std::vector<std::string> describe_audio_devices();

/// An always-running PortAudio stream. The callback only mixes and takes times; a clock map from
/// stream samples to the session clock (CLOCK_MONOTONIC) is fitted to those times on this side.
/// Onsets are of source "stream_time" if the host's times are plausible (judge_stream_times), else
/// "callback_time": callback entry plus the latency that the host states.
class PortaudioOutput final : public AudioOutput {
 public:
  /// Opens the stream and waits until its clock is known (some tenths of a second). Throws
  /// DeviceError, naming the devices found and what to do, if there is no such device, or it
  /// has too few channels, refuses the rate, or asks for no samples.
  explicit PortaudioOutput(const PortaudioOptions& options = {});
  PortaudioOutput(const PortaudioOutput&) = delete;
  PortaudioOutput& operator=(const PortaudioOutput&) = delete;
  PortaudioOutput(PortaudioOutput&&) = delete;
  PortaudioOutput& operator=(PortaudioOutput&&) = delete;
  ~PortaudioOutput() override;

  void schedule(const Sound& sound, Instant onset) override;
  void move(Instant onset) override;
  void stop() override;
  [[nodiscard]] Playback playback() override;
  [[nodiscard]] Duration lead_time() const override;
  [[nodiscard]] Hertz rate() const override;
  [[nodiscard]] std::string kind() const override;
  [[nodiscard]] std::string device_name() const override;
  [[nodiscard]] std::string description() const override;
  [[nodiscard]] std::string_view time_source() const override;

  [[nodiscard]] std::optional<DeviceClock> clock() override;

 private:
  std::unique_ptr<OutputStream> stream_;
};

}  // namespace bimodal::runner
