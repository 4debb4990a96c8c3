#pragma once

#include "runner/devices/display.hpp"
#include "runner/devices/monotonic_clock.hpp"

namespace bimodal::runner {

/// Shows nothing, in real time: keeps the pace of a screen of a stated rate on CLOCK_MONOTONIC, so
/// that a whole session can run on a machine without one. Its onsets are the instants of that grid
/// (predicted), and they say nothing about any real screen.
class HeadlessDisplay final : public Display {
 public:
  struct Options {
    Hertz rate{60.0};  ///< > 0
  };

  HeadlessDisplay();
  explicit HeadlessDisplay(const Options& options);

  /// Sleeps until the planned refresh. The onset is that refresh, even if the machine woke later.
  Presentation present(const Screen& screen, Instant deadline) override;

  void wait(Instant until) override { sleep_until(until); }

  /// The stated grid; deviation and count are 0, because nothing was measured.
  [[nodiscard]] RefreshEstimate refresh() const override { return grid_; }

  [[nodiscard]] std::string kind() const override { return "headless"; }

  [[nodiscard]] std::string description() const override;

  [[nodiscard]] TimeSource time_source() const override { return TimeSource::Predicted; }

 private:
  MonotonicClock clock_;
  Options options_;
  RefreshEstimate grid_;
};

}  // namespace bimodal::runner
