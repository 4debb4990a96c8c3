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

}  // namespace bimodal::runner
