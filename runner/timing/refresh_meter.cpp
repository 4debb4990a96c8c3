#include "runner/timing/refresh_meter.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <span>

namespace bimodal::runner {
namespace {

constexpr double kTolerance = 0.2;        ///< of a period, from a whole multiple
constexpr double kNormalPerMad = 1.4826;  ///< standard deviation of a normal distribution / MAD
constexpr double kOutlierDeviations = 5.0;
constexpr double kLeastOutlier = 0.02;  ///< of a period
constexpr double kLeastGain = 0.2;      ///< about as good as a mean of the last 9
constexpr std::size_t kForPhase = 24;   ///< recent instants; older ones weigh under 1 % then
constexpr std::size_t kForGain = 128;   ///< intervals
constexpr double kSteadiness = 0.01;    ///< of an interval, in which steady ones agree
constexpr int kSteadyIntervals = 12;  ///< of the last 16, to tell a new rate from a loaded machine

/// Reorders `values`. The lower median of an even number.
double median(std::span<double> values) {
  assert(!values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double nanoseconds(Duration duration) {
  return static_cast<double>(duration.count());
}

Duration rounded(double nanoseconds) {
  return Duration{std::llround(nanoseconds)};
}

double off_multiple(double periods) {
  return std::abs(periods - std::round(periods));
}

}  // namespace

void RefreshMeter::add(Instant onset) {
  if (size_ == 0) {
    start_run(onset);
    return;
  }
  const auto interval = onset - last_;
  assert(interval >= Duration::zero());
  last_ = onset;
  ++counts_.intervals;
  if (known_) {
    count_interval(interval);
    if (nanoseconds(interval) > period_ * static_cast<double>(kLongestGap)) {
      first_run_ = false;
      start_run(onset);
      return;
    }
  }
  const auto at = nanoseconds(onset - origin_);
  push({.at = at, .index = known_ ? std::llround((at - intercept_) / period_) : 0});
  if (!known_) number_warm_up();
  if (known_) refit();
  measure_deviation();
  if (known_ && grid_lost()) {
    ++counts_.restarts;
    known_ = false;
    first_run_ = true;
    start_run(onset);
  }
}

void RefreshMeter::start_run(Instant onset) {
  if (size_ > 0 && period_ > 0.0) {
    const auto& latest = recent(0);
    first_ += latest.index + std::llround((nanoseconds(onset - origin_) - latest.at) / period_);
  }
  origin_ = last_ = onset;
  next_ = size_ = 0;
  intercept_ = 0.0;
  push({});
  estimate_.phase = onset;
}

void RefreshMeter::push(Refresh refresh) {
  ring_[next_] = refresh;
  next_ = (next_ + 1) % kWindow;
  size_ = std::min(size_ + 1, kWindow);
}

const RefreshMeter::Refresh& RefreshMeter::recent(std::size_t age) const {
  return ring_[(next_ + kWindow - 1 - age) % kWindow];
}

void RefreshMeter::count_interval(Duration interval) {
  const auto periods = nanoseconds(interval) / period_;
  const auto whole = std::llround(periods);
  if (whole == 1) ++counts_.single;
  if (whole > 1) counts_.skipped += whole - 1;
  if (whole == 0 || off_multiple(periods) > kTolerance) ++counts_.irregular;
}

/// With 16 intervals: their median is the period, and the instants so far get their numbers.
void RefreshMeter::number_warm_up() {
  std::array<double, kWarmUp> intervals{};
  const auto count = size_ - 1;
  for (std::size_t i = 0; i < count; ++i) intervals[i] = recent(i).at - recent(i + 1).at;
  period_ = median(std::span{intervals}.first(count));
  estimate_.period = rounded(period_);
  estimate_.phase = last_;
  estimate_.count = static_cast<int>(counts_.single);
  if (count < kWarmUp) return;
  if (period_ <= 0.0) return start_run(last_);
  known_ = true;
  intercept_ = 0.0;
  for (std::size_t i = 0; i < size_; ++i) {
    ring_[i].index = std::llround(ring_[i].at / period_);
    if (i > 0) count_interval(rounded(ring_[i].at - ring_[i - 1].at));
  }
}

double RefreshMeter::residual(const Refresh& refresh) const {
  return refresh.at - intercept_ - period_ * static_cast<double>(refresh.index);
}

void RefreshMeter::refit() {
  measure_gain();
  fit_line(gain_ > 0.5 ? std::min(size_, kWandering) : size_);
  intercept_ += phase_residual(std::max(kOutlierDeviations * spread_, kLeastOutlier * period_));
  estimate_.period = rounded(period_);
  estimate_.phase = origin_ + rounded(intercept_ + period_ * static_cast<double>(recent(0).index));
  estimate_.count = static_cast<int>(counts_.single);
}

/// From the correlation of single periods with the ones that follow them at once.
void RefreshMeter::measure_gain() {
  const auto single_off = [this](std::size_t age) -> std::optional<double> {
    const auto interval = recent(age).at - recent(age + 1).at;
    const bool is_single = off_multiple(interval / period_) <= kTolerance &&
                           recent(age).index - recent(age + 1).index == 1;
    return is_single ? std::optional{interval - period_} : std::nullopt;
  };
  double squares = 0.0;
  double products = 0.0;
  std::size_t pairs = 0;
  const auto intervals = std::min(size_ - 1, kForGain);
  for (std::size_t age = 1; age < intervals; ++age) {
    const auto later = single_off(age - 1);
    const auto earlier = single_off(age);
    if (!later || !earlier) continue;
    products += *later * *earlier;
    squares += 0.5 * (*later * *later + *earlier * *earlier);
    ++pairs;
  }
  gain_ = kLeastGain;
  if (pairs < kWarmUp) return;
  const double rho = squares > 0.0 ? products / squares : -0.5;
  if (rho >= 0.0) {
    gain_ = 1.0;
  } else if (rho > -0.5) {
    const double theta = (1.0 - std::sqrt(1.0 - 4.0 * rho * rho)) / (2.0 * -rho);
    gain_ = std::max(1.0 - theta, kLeastGain);
  }
}

/// Through the last `count` instants, without outliers.
void RefreshMeter::fit_line(std::size_t count) {
  std::array<double, kWindow> residuals{};
  const auto window = std::span{residuals}.first(count);
  for (std::size_t age = 0; age < count; ++age) window[age] = residual(recent(age));
  const auto middle = median(window);
  for (std::size_t age = 0; age < count; ++age) {
    window[age] = std::abs(residual(recent(age)) - middle);
  }
  spread_ = kNormalPerMad * median(window);
  const auto limit = std::max(kOutlierDeviations * spread_, kLeastOutlier * period_);
  const auto is_outlier = [&](const Refresh& refresh) {
    return std::abs(residual(refresh) - middle) > limit;
  };
  double used = 0.0;
  double mean_index = 0.0;
  double mean_at = 0.0;
  for (std::size_t age = 0; age < count; ++age) {
    const auto& refresh = recent(age);
    if (is_outlier(refresh)) continue;
    used += 1.0;
    mean_index += (static_cast<double>(refresh.index) - mean_index) / used;
    mean_at += (refresh.at - mean_at) / used;
  }
  rejected_ = count - static_cast<std::size_t>(used);
  double covariance = 0.0;
  double variance = 0.0;
  for (std::size_t age = 0; age < count; ++age) {
    const auto& refresh = recent(age);
    if (is_outlier(refresh)) continue;
    const auto from_mean = static_cast<double>(refresh.index) - mean_index;
    covariance += from_mean * (refresh.at - mean_at);
    variance += from_mean * from_mean;
  }
  const auto enough = first_run_ ? kWarmUp : kEnoughForPeriod;
  if (size_ >= enough && variance > 0.0) period_ = covariance / variance;
  intercept_ = mean_at - period_ * mean_index;
}

/// Where the grid lies now, off the line.
double RefreshMeter::phase_residual(double limit) const {
  const auto count = std::min(size_, kForPhase);
  std::array<double, kForPhase> oldest_first{};
  for (std::size_t age = 0; age < count; ++age) {
    oldest_first[count - 1 - age] = residual(recent(age));
  }
  std::array<double, 3> oldest{};
  const auto start = std::span{oldest}.first(std::min(count, oldest.size()));
  std::copy_n(oldest_first.begin(), start.size(), start.begin());
  double phase = median(start);
  for (std::size_t i = 1; i < count; ++i) {
    const double off = oldest_first[i] - phase;
    if (std::abs(off) <= limit) {
      phase += gain_ * off;
    } else if (i >= 2 && std::abs(oldest_first[i] - oldest_first[i - 1]) <= limit &&
               std::abs(oldest_first[i] - oldest_first[i - 2]) <= limit) {
      phase = oldest_first[i];  // three agree: time was lost at once
    }
  }
  return phase;
}

ClockFit RefreshMeter::fit() const {
  return {.sample = size_ == 0 ? 0 : first_ + recent(0).index,
          .instant = estimate_.phase,
          .nanoseconds_per_sample = period_,
          .drift_ppm = 0.0,
          .residual = rounded(spread_),
          .count = size_ - std::min(rejected_, size_),
          .rejected = rejected_};
}

bool RefreshMeter::grid_lost() const {
  if (size_ <= kWarmUp) return false;
  std::array<double, kWarmUp> intervals{};
  for (std::size_t age = 0; age < kWarmUp; ++age) {
    intervals[age] = recent(age).at - recent(age + 1).at;
  }
  const auto typical = median(intervals);
  const auto alike = std::ranges::count_if(intervals, [typical](double interval) {
    return std::abs(interval - typical) <= kSteadiness * typical;
  });
  return alike >= kSteadyIntervals && off_multiple(typical / period_) > 2.0 * kSteadiness;
}

void RefreshMeter::measure_deviation() {
  double count = 0.0;
  double mean = 0.0;
  double squares = 0.0;
  for (std::size_t age = 0; age + 1 < size_; ++age) {
    const auto interval = recent(age).at - recent(age + 1).at;
    if (std::llround(interval / period_) != 1) continue;
    count += 1.0;
    const auto from_mean = interval - mean;
    mean += from_mean / count;
    squares += from_mean * (interval - mean);
  }
  if (count >= 2.0) estimate_.deviation = rounded(std::sqrt(squares / (count - 1.0)));
}

}  // namespace bimodal::runner
