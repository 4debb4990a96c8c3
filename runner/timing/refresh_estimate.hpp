#pragma once

#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// The grid on which a display shows new pictures: phase + k * period for every whole k.
struct RefreshEstimate {
  Duration period{};     ///< 0: not known
  Duration deviation{};  ///< standard deviation of single periods
  int count = 0;         ///< periods measured; 0: the period is nominal
  Instant phase{};       ///< an instant at which a refresh took place
};

/// The refresh nearest to `wanted` on the grid of `estimate`; half-way, the later one. With an
/// unknown period, `wanted` itself.
[[nodiscard]] Instant nearest_refresh(const RefreshEstimate& estimate, Instant wanted);

/// The first refresh at `instant` or later. With an unknown period, `instant` itself.
[[nodiscard]] Instant refresh_not_before(const RefreshEstimate& estimate, Instant instant);

/// The period of a stated rate, rounded to the nearest nanosecond.
[[nodiscard]] Duration period_of(Hertz rate);

}  // namespace bimodal::runner
