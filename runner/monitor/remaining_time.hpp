#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// Estimates how long a session goes on from how long its latest trials took. The median of the
/// last 20: a participant who paused once, or speeds up, changes little or soon. Breaks are not
/// counted. Pure.
class RemainingTime {
 public:
  static constexpr std::size_t kLatest = 20;
  static constexpr std::size_t kFewest = 3;  ///< before so many trials there is no estimate

  /// From the beginning of its preparation to the end of its storing, pauses left out.
  void add(Duration trial);

  /// The median (of an even number: the mean of the middle two, rounded down).
  [[nodiscard]] std::optional<Duration> typical_trial() const;

  [[nodiscard]] std::optional<Duration> left(std::size_t trials_to_come) const;

 private:
  std::deque<Duration> latest_;
};

}  // namespace bimodal::runner
