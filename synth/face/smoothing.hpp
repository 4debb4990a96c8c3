#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace bimodal::synth {

/// 0 below `from`, 1 beyond `to` (which may be the lower), a cubic with level ends between.
[[nodiscard]] inline double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Straight lines through (x[i], y[i]), x increasing; level beyond both ends.
template <std::size_t N>
[[nodiscard]] double interpolate(double at,
                                 const std::array<double, N>& x,
                                 const std::array<double, N>& y) {
  if (at <= x.front()) return y.front();
  for (std::size_t i = 1; i < N; ++i) {
    if (at < x[i]) return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
  }
  return y.back();
}

}  // namespace bimodal::synth
