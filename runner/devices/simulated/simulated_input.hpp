#pragma once

#include <cstddef>
#include <vector>

#include "runner/devices/audio_input.hpp"
#include "runner/devices/clock.hpp"

namespace bimodal::runner {

/// A microphone before which somebody speaks: every capture but the first (that of the room) hears
/// the next of its utterances, from the first again after the last, with the room before and after
/// it. On whatever clock: as many samples are there as time has passed.
class SimulatedInput final : public AudioInput {
 public:
  struct Options {
    Hertz rate{48'000};
    std::vector<float> room;                             ///< heard over and over; empty: silence
    std::vector<std::vector<float>> utterances;          ///< empty: nobody ever speaks
    Duration reaction = std::chrono::milliseconds{400};  ///< from the start to the utterance
  };

  /// `clock` is borrowed and must outlive the input.
  SimulatedInput(const Clock& clock, Options options);

  void start() override;
  void collect(std::vector<float>& samples) override;
  void stop() override;

  [[nodiscard]] std::int64_t lost() const override { return 0; }

  [[nodiscard]] Hertz rate() const override { return options_.rate; }

  [[nodiscard]] std::string kind() const override { return "simulated"; }

  [[nodiscard]] std::string description() const override;

 private:
  [[nodiscard]] float sample_at(std::size_t index) const;

  const Clock& clock_;  ///< borrowed
  Options options_;
  std::size_t captures_ = 0;
  bool running_ = false;
  Instant start_;
  std::size_t delivered_ = 0;
};

}  // namespace bimodal::runner
