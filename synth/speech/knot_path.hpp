#pragma once

#include <algorithm>
#include <vector>

#include "synth/speech/movement.hpp"

namespace bimodal::synth {

/// A control that moves on straight lines from knot to knot and rests before the first and after
/// the last.
struct KnotPath {
  struct Knot {
    double time_ms;
    double value;
  };

  std::vector<Knot> knots;  ///< in order of time; of several at one time the last counts

  /// The piece that holds a time: its ends are knots i and i + 1, `along` is 0 to 1 on the way.
  struct Place {
    std::size_t knot;
    double along;
  };

  /// Precondition: there are knots.
  [[nodiscard]] Place place(double time_ms) const {
    const auto after = std::ranges::upper_bound(knots, time_ms, {}, &Knot::time_ms);
    if (after == knots.begin()) return {.knot = 0, .along = 0};
    const auto i = static_cast<std::size_t>(after - knots.begin()) - 1;
    if (after == knots.end()) return {.knot = i, .along = 0};
    return {.knot = i, .along = (time_ms - knots[i].time_ms) / (after->time_ms - knots[i].time_ms)};
  }
};

}  // namespace bimodal::synth
