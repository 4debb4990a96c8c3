#include "runner/timing/refresh_meter.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

namespace bimodal::runner {
namespace {

constexpr double kTolerance = 0.2;        ///< of a period, from a whole multiple
constexpr double kNormalPerMad = 1.4826;  ///< standard deviation of a normal distribution / MAD
constexpr double kOutlierDeviations = 5.0;
constexpr double kLeastOutlier = 0.02;  ///< of a period
constexpr std::size_t kForPhase = 9;    ///< recent instants
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

void RefreshMeter::refit() {
  std::array<double, kWindow> residuals{};
  const auto residual = [this](const Refresh& refresh) {
    return refresh.at - intercept_ - period_ * static_cast<double>(refresh.index);
  };
  for (std::size_t i = 0; i < size_; ++i) residuals[i] = residual(ring_[i]);
  const auto middle = median(std::span{residuals}.first(size_));
  for (std::size_t i = 0; i < size_; ++i) residuals[i] = std::abs(residual(ring_[i]) - middle);
  const auto spread = kNormalPerMad * median(std::span{residuals}.first(size_));
  const auto limit = std::max(kOutlierDeviations * spread, kLeastOutlier * period_);

  const auto is_outlier = [&](const Refresh& refresh) {
    return std::abs(residual(refresh) - middle) > limit;
  };
  double count = 0.0;
  double mean_index = 0.0;
  double mean_at = 0.0;
  for (std::size_t i = 0; i < size_; ++i) {
    if (is_outlier(ring_[i])) continue;
    count += 1.0;
    mean_index += (static_cast<double>(ring_[i].index) - mean_index) / count;
    mean_at += (ring_[i].at - mean_at) / count;
  }
  double covariance = 0.0;
  double variance = 0.0;
  for (std::size_t i = 0; i < size_; ++i) {
    if (is_outlier(ring_[i])) continue;
    const auto from_mean = static_cast<double>(ring_[i].index) - mean_index;
    covariance += from_mean * (ring_[i].at - mean_at);
    variance += from_mean * from_mean;
  }
  const auto enough = first_run_ ? kWarmUp : kEnoughForPeriod;
  if (size_ >= enough && variance > 0.0) period_ = covariance / variance;
  intercept_ = mean_at - period_ * mean_index;

  const auto recent_count = std::min(size_, kForPhase);
  for (std::size_t age = 0; age < recent_count; ++age) residuals[age] = residual(recent(age));
  intercept_ += median(std::span{residuals}.first(recent_count));
  estimate_.period = rounded(period_);
  estimate_.phase = origin_ + rounded(intercept_ + period_ * static_cast<double>(recent(0).index));
  estimate_.count = static_cast<int>(counts_.single);
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
