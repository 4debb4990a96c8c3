#pragma once

#include <vector>

#include "runner/cli/timing_run.hpp"
#include "runner/devices/audio_input.hpp"

namespace bimodal::runner {

/// A photodiode on the flash and a cable from the sound output, both on one sound input: they tell
/// when light and sound really came, by one clock.
class Instruments {
 public:
  struct Options {
    std::size_t photodiode = 0;  ///< its channel of the input, from 0
    std::size_t loopback = 1;    ///< that of the sound
    /// What reaches the input comes so late, light and sound alike (0 for cables).
    Duration delay{};
  };

  /// `input` is borrowed; its capture begins.
  Instruments(AudioInput& input, const Options& options);

  /// Takes what has arrived. To be called at least every second.
  void collect();

  /// Waits until what `trial` presented has arrived, presenting nothing new meanwhile but calling
  /// `rest`, and writes down when light and sound really came: neither, if the input's clock jumped
  /// meanwhile, for then they lie on two clocks. Throws DeviceError if the input is lost.
  void find(TimedTrial& trial, const std::function<void()>& rest);

  [[nodiscard]] std::int64_t lost() const { return input_.lost(); }

 private:
  [[nodiscard]] std::vector<float> channel(std::size_t which,
                                           std::int64_t from,
                                           std::size_t count) const;
  [[nodiscard]] std::int64_t captured() const;
  [[nodiscard]] Instant instant_of(double frame);

  AudioInput& input_;
  Options options_;
  std::vector<float> samples_;  ///< interleaved, from stream frame first_ on
  std::int64_t first_ = 0;
};

}  // namespace bimodal::runner
