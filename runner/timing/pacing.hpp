#pragma once

#include <span>

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

/// When a screen appeared, and whether that was seen or only follows from the plan.
struct SwapOnset {
  Instant onset;
  bool seen = false;
};

/// Reads the instant at which a swap planned by `plan` returned. A driver with room for one more
/// picture returns before the refresh: then the target is the best that is known. Within a quarter
/// of a period before the target, or later, the swap is taken to have waited for its refresh.
[[nodiscard]] SwapOnset onset_of_swap(const RefreshEstimate& grid,
                                      const RefreshPlan& plan,
                                      Instant returned);

/// Whether `intervals` between the returns of swaps in a loop show that the swap waits for a screen
/// whose nominal period is given: at most a quarter of them shorter than half of it. (A driver that
/// only copies returns after as long as copying takes, which grows with the load of the machine.)
[[nodiscard]] bool swap_waits(std::span<const Duration> intervals, Duration nominal_period);

}  // namespace bimodal::runner
