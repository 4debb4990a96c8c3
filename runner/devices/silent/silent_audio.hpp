#pragma once

#include <optional>

#include "runner/devices/audio_output.hpp"
#include "runner/devices/clock.hpp"

namespace bimodal::runner {

/// No sound at all (`--audio none`), for machines without a sound device. It never claims an onset;
/// a sound counts as finished once it would have been over, so that the session keeps its pace.
class SilentAudio final : public AudioOutput {
 public:
  /// The clock must outlive this.
  explicit SilentAudio(const Clock& clock, Hertz rate = Hertz{48'000});

  void schedule(const Sound& sound, Instant onset) override;
  void move(Instant onset) override;
  void stop() override;
  [[nodiscard]] Playback playback() override;

  [[nodiscard]] Duration lead_time() const override { return {}; }

  [[nodiscard]] Hertz rate() const override { return rate_; }

  [[nodiscard]] std::string kind() const override { return "none"; }

  [[nodiscard]] std::string description() const override { return "no sound device is used"; }

  [[nodiscard]] std::string_view time_source() const override { return "none"; }

 private:
  const Clock& clock_;
  Hertz rate_;
  Duration length_{};
  std::optional<Instant> end_;
};

}  // namespace bimodal::runner
