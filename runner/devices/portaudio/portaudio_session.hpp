#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace bimodal::runner {

/// Sends what is printed on stderr to /dev/null while it lives: ALSA and JACK complain there about
/// every device that they do not find. Not for use while other threads print.
class SilencedStderr {
 public:
  SilencedStderr();
  SilencedStderr(const SilencedStderr&) = delete;
  SilencedStderr& operator=(const SilencedStderr&) = delete;
  SilencedStderr(SilencedStderr&&) = delete;
  SilencedStderr& operator=(SilencedStderr&&) = delete;
  ~SilencedStderr();

 private:
  int kept_ = -1;  ///< the real stderr
};

/// A device with outputs, or one with inputs.
struct AudioDevice {
  int index = 0;  ///< PortAudio's
  std::string name;
  std::string host;  ///< "ALSA", "JACK Audio Connection Kit"
  int channels = 0;
  double default_rate = 0.0;
  double safe_latency = 0.0;  ///< s, with which the host expects no gaps
  bool is_default = false;
};

/// "2: system (JACK Audio Connection Kit), 2 channels, 48000 samples per second, default".
[[nodiscard]] std::string describe(const AudioDevice& device);

/// PortAudio, initialised as long as this lives. Throws DeviceError if it cannot be.
class PortaudioSession {
 public:
  PortaudioSession();
  PortaudioSession(const PortaudioSession&) = delete;
  PortaudioSession& operator=(const PortaudioSession&) = delete;
  PortaudioSession(PortaudioSession&&) = delete;
  PortaudioSession& operator=(PortaudioSession&&) = delete;
  ~PortaudioSession();

  /// Those with outputs, in PortAudio's order.
  [[nodiscard]] const std::vector<AudioDevice>& devices() const { return devices_; }

  /// Those with inputs, in PortAudio's order, with what is true of their inputs.
  [[nodiscard]] const std::vector<AudioDevice>& inputs() const { return inputs_; }

  /// Leaves PortAudio as it is at the end: for when its sound server is gone.
  void abandon() { abandoned_ = true; }

 private:
  std::vector<AudioDevice> devices_;
  std::vector<AudioDevice> inputs_;
  bool abandoned_ = false;
};

/// How messages name a device of one direction, and the way without it.
struct SoundUse {
  std::string_view device = "sound output";
  std::string_view remedy = "run a session without sound (`bimodal run ... --audio none`)";
};

inline constexpr SoundUse kPlaying{};
inline constexpr SoundUse kRecording{
    "microphone", "try without one by --input simulated:FILE, a recording of the words"};
inline constexpr SoundUse kMeasuring{"sound input", "leave out --input: without instruments"};

/// The device meant by an index, a whole name or a part of a name (the first that has it); empty
/// means the default, or the first if there is none. Throws DeviceError listing the devices if none
/// is meant.
[[nodiscard]] const AudioDevice& choose_device(const std::vector<AudioDevice>& devices,
                                               const std::string& wanted,
                                               const SoundUse& use = kPlaying);

}  // namespace bimodal::runner
