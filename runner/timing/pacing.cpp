#include "runner/timing/pacing.hpp"

#include <algorithm>

namespace bimodal::runner {

RefreshPlan plan_refresh(const RefreshEstimate& grid, Instant now, Instant deadline) {
  if (grid.period <= Duration::zero()) return {.target = std::max(now, deadline), .submit = now};
  const auto wanted = refresh_not_before(grid, deadline - grid.period / 2);
  const auto reachable = refresh_not_before(grid, now + Duration{1});
  const auto target = std::max(wanted, reachable);
  return {.target = target, .submit = target - grid.period + grid.period / 8};
}

SwapOnset onset_of_swap(const RefreshEstimate& grid, const RefreshPlan& plan, Instant returned) {
  if (returned < plan.target - grid.period / 4) return {.onset = plan.target, .seen = false};
  return {.onset = returned, .seen = true};
}

bool swap_waits(std::span<const Duration> intervals, Duration nominal_period) {
  const auto short_ones = std::ranges::count_if(
      intervals, [&](Duration interval) { return 2 * interval < nominal_period; });
  return 4 * static_cast<std::size_t>(short_ones) <= intervals.size();
}

}  // namespace bimodal::runner
