#include "runner/devices/simulated/simulated_display.hpp"

#include <fmt/format.h>

#include "runner/timing/pacing.hpp"

namespace bimodal::runner {

SimulatedDisplay::SimulatedDisplay(VirtualClock& clock) : SimulatedDisplay{clock, Options{}} {}

SimulatedDisplay::SimulatedDisplay(VirtualClock& clock, const Options& options)
    : clock_{clock},
      options_{options},
      grid_{.period = period_of(options.rate), .phase = options.phase} {}

Presentation SimulatedDisplay::present(const Screen& screen, Instant deadline) {
  const auto onset = plan_refresh(grid_, clock_.now(), deadline).target + to_drop_ * grid_.period;
  to_drop_ = 0;
  clock_.advance_to(onset);
  const Presentation presentation{
      .onset = onset, .source = TimeSource::Predicted, .lateness = onset - deadline};
  if (observer_) observer_(screen, presentation);
  return presentation;
}

std::string SimulatedDisplay::description() const {
  return fmt::format("simulated: refreshes of {:g} Hz in virtual time, nothing is shown",
                     options_.rate.count());
}

}  // namespace bimodal::runner
