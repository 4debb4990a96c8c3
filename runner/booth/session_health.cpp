#include "runner/booth/session_health.hpp"

namespace bimodal::runner {

namespace {

/// Refreshes that passed between frames, which are to follow each other at every refresh.
std::int64_t missed_in(const RefreshRecord& refreshes, Duration period) {
  std::int64_t missed = 0;
  for (std::size_t i = 1; i < refreshes.shown.size(); ++i) {
    const auto passed = refreshes.shown[i] - refreshes.shown[i - 1];
    missed += passed > 3 * period / 2 ? (passed + period / 2) / period - 1 : 0;
  }
  return missed;
}

std::int64_t late_in(const RefreshRecord& refreshes, Duration period) {
  std::int64_t late = 0;
  for (std::size_t i = 0; i < refreshes.shown.size(); ++i) {
    late += refreshes.shown[i] - refreshes.planned[i] > period / 2 ? 1 : 0;
  }
  return late;
}

}  // namespace

void SessionHealth::add(const TrialRecord& trial, Duration period, std::int64_t underflows) {
  if (period > Duration::zero()) {
    health_.missed_refreshes += missed_in(trial.refreshes, period);
    health_.late_frames += late_in(trial.refreshes, period);
  }
  health_.underflows += underflows;
  health_.sound_drift_ppm.reset();
  for (const auto& map : trial.clock_maps) {
    if (map.clock == "sound") health_.sound_drift_ppm = map.drift_ppm;
  }
}

Health SessionHealth::at(Instant instant, const RefreshEstimate& refresh) const {
  auto health = health_;
  health.at = instant;
  health.refresh_period = refresh.period;
  health.refresh_deviation = refresh.deviation;
  health.refreshes_measured = refresh.count;
  return health;
}

}  // namespace bimodal::runner
