#pragma once

#include <functional>

#include "runner/devices/display.hpp"
#include "runner/devices/simulated/virtual_clock.hpp"

namespace bimodal::runner {

/// A screen that keeps a perfect refresh grid in virtual time: presenting advances the clock to the
/// refresh. Shows nothing; whoever wants to know what was presented observes it.
class SimulatedDisplay final : public Display {
 public:
  struct Options {
    Hertz rate{60.0};  ///< > 0
    Instant phase{};   ///< an instant of the grid
  };

  using Observer = std::function<void(const Screen&, const Presentation&)>;

  /// `clock` is borrowed and must outlive the display.
  explicit SimulatedDisplay(VirtualClock& clock);
  SimulatedDisplay(VirtualClock& clock, const Options& options);

  Presentation present(const Screen& screen, Instant deadline) override;

  void wait(Instant until) override { clock_.advance_to(until); }

  /// The next presentation comes `refreshes` (>= 0) late; those after it are on time again.
  void drop_next(int refreshes) { to_drop_ = refreshes; }

  /// Called with every presentation, before present() returns.
  void observe(Observer observer) { observer_ = std::move(observer); }

  /// The stated grid; deviation and count are 0, because nothing was measured.
  [[nodiscard]] RefreshEstimate refresh() const override { return grid_; }

  [[nodiscard]] std::string kind() const override { return "simulated"; }

  [[nodiscard]] std::string description() const override;

  [[nodiscard]] TimeSource time_source() const override { return TimeSource::Predicted; }

 private:
  VirtualClock& clock_;  ///< borrowed
  Options options_;
  RefreshEstimate grid_;
  int to_drop_ = 0;
  Observer observer_;
};

}  // namespace bimodal::runner
