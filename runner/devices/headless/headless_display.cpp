#include "runner/devices/headless/headless_display.hpp"

#include <fmt/format.h>

#include "runner/timing/pacing.hpp"

namespace bimodal::runner {

HeadlessDisplay::HeadlessDisplay() : HeadlessDisplay{Options{}} {}

HeadlessDisplay::HeadlessDisplay(const Options& options)
    : options_{options}, grid_{.period = period_of(options.rate), .phase = clock_.now()} {}

Presentation HeadlessDisplay::present(const Screen& /*screen*/, Instant deadline) {
  const auto plan = plan_refresh(grid_, clock_.now(), deadline);
  sleep_until(plan.target);
  return {
      .onset = plan.target, .source = TimeSource::Predicted, .lateness = plan.target - deadline};
}

std::string HeadlessDisplay::description() const {
  return fmt::format("no display: nothing is shown; refreshes of {:g} Hz are kept by the clock",
                     options_.rate.count());
}

}  // namespace bimodal::runner
