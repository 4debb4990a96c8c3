#include "runner/monitor/remaining_time.hpp"

#include <algorithm>
#include <vector>

namespace bimodal::runner {

void RemainingTime::add(Duration trial) {
  latest_.push_back(trial);
  if (latest_.size() > kLatest) latest_.pop_front();
}

std::optional<Duration> RemainingTime::typical_trial() const {
  if (latest_.size() < kFewest) return std::nullopt;
  std::vector<Duration> sorted(latest_.begin(), latest_.end());
  std::ranges::sort(sorted);
  const auto middle = sorted.size() / 2;
  if (sorted.size() % 2 == 1) return sorted[middle];
  return (sorted[middle - 1] + sorted[middle]) / 2;
}

std::optional<Duration> RemainingTime::left(std::size_t trials_to_come) const {
  const auto typical = typical_trial();
  if (!typical) return std::nullopt;
  return *typical * static_cast<std::int64_t>(trials_to_come);
}

}  // namespace bimodal::runner
