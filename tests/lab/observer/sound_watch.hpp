#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace lab {

/// A sound that began after silence.
struct SeenSound {
  int channel = 0;
  std::int64_t at_ns = 0;  ///< CLOCK_MONOTONIC: its first sample at the sound card's output
  float first = 0.0F;      ///< that sample
};

/// Something that went wrong in the sound server.
struct SeenTrouble {
  std::int64_t at_ns = 0;
};

/// Listens to what another program plays, as a client of the same JACK server, and may play the
/// brightness of a screen into what that program records. It knows nothing of the program.
class SoundWatch {
 public:
  struct Options {
    int channels = 2;             ///< that are listened to
    double longest_s = 900;       ///< recorded at most
    float threshold = 1e-4F;      ///< a larger sample is sound
    double silence_s = 0.1;       ///< that must go before a sound
    double diode_delay_s = 0.05;  ///< from a refresh to its brightness in the played signal
  };

  /// Connects to the JACK server. Throws std::runtime_error.
  explicit SoundWatch(const Options& options);
  SoundWatch(const SoundWatch&) = delete;
  SoundWatch& operator=(const SoundWatch&) = delete;
  SoundWatch(SoundWatch&&) = delete;
  SoundWatch& operator=(SoundWatch&&) = delete;
  ~SoundWatch();

  /// Connects to the ports of whoever plays, once they are there: "NAME:out_0" and so on. The diode
  /// goes to NAME:in_0 and the first played channel back to NAME:in_1, if there are inputs. To be
  /// called again and again; true once connected.
  bool connect(const std::string& client_pattern);

  /// Brightness 0 to 1 since a refresh at `at_ns`, for the diode signal.
  void show(std::int64_t at_ns, float brightness);

  /// What has been heard, on CLOCK_MONOTONIC. To be called when nothing plays any more.
  [[nodiscard]] std::vector<SeenSound> sounds() const;
  [[nodiscard]] std::vector<SeenTrouble> troubles() const;

 private:
  struct Client;
  std::unique_ptr<Client> client_;
};

}  // namespace lab
