#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runner/devices/audio_input.hpp"

namespace bimodal::runner {

struct PortaudioInputOptions {
  std::string device;  ///< index, or part of a name as describe_microphones() prints it; empty: the
                       ///< default device
  Hertz rate{48'000};
  std::size_t channels = 1;   ///< the first so many of the device
  bool is_measuring = false;  ///< instruments are on it; else somebody speaks: for messages
};

/// One line per device with inputs: "2: system (JACK Audio Connection Kit), 2 channels, 48000
/// samples per second", the default marked.
[[nodiscard]] std::vector<std::string> describe_microphones();

/// An always-running PortAudio stream, whose callback only puts samples into a buffer of some
/// seconds, and takes times, to which a clock map from frames to the session clock is fitted on
/// this side.
class PortaudioInput final : public AudioInput {
 public:
  /// Opens the stream and waits for its first samples. Throws DeviceError, naming the devices found
  /// and what to do, if there is no such device, or it refuses the rate, or delivers no samples.
  explicit PortaudioInput(const PortaudioInputOptions& options = {});
  PortaudioInput(const PortaudioInput&) = delete;
  PortaudioInput& operator=(const PortaudioInput&) = delete;
  PortaudioInput(PortaudioInput&&) = delete;
  PortaudioInput& operator=(PortaudioInput&&) = delete;
  ~PortaudioInput() override;

  void start() override;
  void collect(std::vector<float>& samples) override;
  void stop() override;
  [[nodiscard]] std::int64_t lost() const override;
  [[nodiscard]] std::size_t channels() const override;
  [[nodiscard]] std::int64_t first_frame() const override;
  [[nodiscard]] std::optional<DeviceClock> clock() override;
  [[nodiscard]] Hertz rate() const override;
  [[nodiscard]] std::string kind() const override;
  [[nodiscard]] std::string description() const override;

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

}  // namespace bimodal::runner
