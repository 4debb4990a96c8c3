#pragma once

#include <cstdint>
#include <optional>

#include "runner/devices/audio_output.hpp"
#include "runner/devices/clock.hpp"

namespace bimodal::runner {

/// Sound in virtual time: every sound starts at the instant it was scheduled for (or now, if that
/// is past) and ends after its duration, by the clock it is given. Source "predicted".
class SimulatedAudio final : public AudioOutput {
 public:
  /// The clock must outlive this.
  explicit SimulatedAudio(const Clock& clock, Hertz rate = Hertz{48'000});

  void schedule(const Sound& sound, Instant onset) override;
  void move(Instant onset) override;
  void stop() override;
  [[nodiscard]] Playback playback() override;

  [[nodiscard]] Duration lead_time() const override { return {}; }

  [[nodiscard]] Hertz rate() const override { return rate_; }

  [[nodiscard]] std::string kind() const override { return "simulated"; }

  [[nodiscard]] std::string description() const override;

  [[nodiscard]] std::string_view time_source() const override { return "predicted"; }

 private:
  struct Span {
    Instant start;
    Instant end;
  };

  const Clock& clock_;
  Hertz rate_;
  std::optional<Span> sound_;
};

}  // namespace bimodal::runner
