#pragma once

#include "runner/timing/refresh_estimate.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// What a display does with one deadline.
struct RefreshPlan {
  Instant target;  ///< the refresh at which the screen shall appear
  Instant submit;  ///< handed over before this instant, it might appear one refresh too early
};

/// Chooses the first refresh not earlier than `deadline` less half a period, of those that can
/// still be met: the ones after `now`. The screen may be handed over from an eighth of a period
/// after the refresh before `target` on, so that neither a stamp that is a little off nor a little
/// jitter lets it slip into that earlier refresh. With an unknown period: at once.
[[nodiscard]] RefreshPlan plan_refresh(const RefreshEstimate& grid, Instant now, Instant deadline);

/// Whether a swap that takes `median_interval` in a loop waits for the screen at all. Real screens
/// need 2 ms (480 Hz) or more; a driver that only copies returns in a fraction of that.
[[nodiscard]] constexpr bool swap_waits(Duration median_interval) {
  return median_interval >= std::chrono::milliseconds{2};
}

}  // namespace bimodal::runner
