#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "runner/timing/clock_map.hpp"
#include "runner/timing/refresh_estimate.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// What was irregular among the intervals between the instants given to a RefreshMeter.
struct RefreshCounts {
  std::int64_t intervals = 0;
  std::int64_t single = 0;     ///< about one period long (0.5 to 1.5)
  std::int64_t skipped = 0;    ///< refreshes that lay inside the longer ones
  std::int64_t irregular = 0;  ///< more than 20 % of a period off every whole multiple
  std::int64_t restarts = 0;   ///< the period was lost and measured anew: the screen's rate changed
};

/// Estimates a screen's refresh grid from the instants at which pictures were presented, which may
/// be jittered, late once in a while, and many refreshes apart.
///
/// The first 16 intervals give the period by their median, so fewer than half of them may be
/// irregular. From then on every instant is given its whole number of periods, and a straight line
/// is fitted through the last 512 instants by least squares, leaving out those whose residual is
/// more than 5 scaled median absolute deviations (at least 2 % of a period) off the median. Its
/// slope is the period.
///
/// The phase is an exponentially weighted mean of the instants along that line. How much the last
/// instant weighs follows from what the screen is like. The stamps of a screen with a crystal are
/// noise about a fixed grid: a long interval is followed by a short one, and little weight (1/5) is
/// best. A compositor with a timer of its own counts each period from the last refresh: its grid
/// wanders, and the last instant says all. In between, where refreshes wander and stamps are noisy,
/// intervals are a moving average of order 1, and the best weight is 1 - |theta|, its coefficient
/// by the intervals' correlation with the next one, rho = theta / (1 + theta^2) (Muth 1960, J. Am.
/// Stat. Assoc. 55:299). Where it is above 1/2, the period is that of the last 64 instants. An
/// instant far off counts only when the two before it agree with it: a timer may lose time at once.
/// After a gap longer than 64 periods the numbering starts anew; the period is kept until 100 new
/// instants can tell it. Only when 12 of the last 16 intervals agree within 1 % on a length that is
/// 2 % off every multiple of the period, everything starts anew: the screen has another rate.
/// Intervals that are merely irregular, as on an overloaded machine, do not unsettle the grid.
///
/// Allocates nothing. Not for concurrent use.
class RefreshMeter {
 public:
  static constexpr std::size_t kWindow = 512;
  static constexpr std::size_t kWandering = 64;  ///< of a grid that wanders
  static constexpr std::size_t kWarmUp = 16;
  static constexpr std::size_t kEnoughForPeriod = 100;
  static constexpr std::int64_t kLongestGap = 64;

  /// Takes the instant of one presentation, not earlier than the one before.
  void add(Instant onset);

  /// The period, the standard deviation of the single periods in the window, the number of single
  /// periods measured, and the fitted instant of the last refresh. Period 0 before two instants.
  [[nodiscard]] const RefreshEstimate& estimate() const { return estimate_; }

  [[nodiscard]] const RefreshCounts& counts() const { return counts_; }

  /// The grid as a clock that counts refreshes from the first one measured, missed ones included.
  [[nodiscard]] ClockFit fit() const;

  /// The weight of the last instant in the phase, from 1/5 (a fixed grid) to 1 (one that wanders).
  [[nodiscard]] double gain() const { return gain_; }

 private:
  struct Refresh {
    double at = 0.0;         ///< ns since origin_
    std::int64_t index = 0;  ///< whole periods since the first of this run
  };

  void count_interval(Duration interval);
  void push(Refresh refresh);
  void start_run(Instant onset);
  void number_warm_up();
  void refit();
  void measure_gain();
  void fit_line(std::size_t count);
  [[nodiscard]] double phase_residual(double limit) const;
  [[nodiscard]] double residual(const Refresh& refresh) const;
  void measure_deviation();
  [[nodiscard]] bool grid_lost() const;
  [[nodiscard]] const Refresh& recent(std::size_t age) const;

  std::array<Refresh, kWindow> ring_{};
  std::size_t next_ = 0;
  std::size_t size_ = 0;
  bool known_ = false;      ///< the period is
  bool first_run_ = true;   ///< since the period was last unknown
  double period_ = 0.0;     ///< ns
  double intercept_ = 0.0;  ///< fitted instant of index 0, ns since origin_
  double gain_ = 0.2;
  double spread_ = 0.0;       ///< robust standard deviation about the line, ns
  std::size_t rejected_ = 0;  ///< of the instants in the window
  std::int64_t first_ = 0;    ///< number of index 0 since the first refresh measured
  Instant origin_;
  Instant last_;
  RefreshEstimate estimate_;
  RefreshCounts counts_;
};

}  // namespace bimodal::runner
