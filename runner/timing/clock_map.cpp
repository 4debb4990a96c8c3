#include "runner/timing/clock_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace bimodal::runner {

namespace {

constexpr double kNanosecondsPerSecond = 1e9;
constexpr double kDeviationPerMedianDeviation = 1.4826;  // of a normal distribution
constexpr double kRejectBeyond = 4.0;                    // robust standard deviations

/// The upper median; values must not be empty.
double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Readings relative to the one in the middle, so that nothing is lost in doubles.
struct Readings {
  ClockPair origin;
  std::vector<double> samples;
  std::vector<double> nanoseconds;
};

Readings relative(std::span<const ClockPair> pairs) {
  Readings readings{pairs[pairs.size() / 2], {}, {}};
  for (const auto& pair : pairs) {
    readings.samples.push_back(static_cast<double>(pair.sample - readings.origin.sample));
    readings.nanoseconds.push_back(
        static_cast<double>((pair.instant - readings.origin.instant).count()));
  }
  return readings;
}

/// Of pairs half the readings apart; `otherwise` if none of them differ in their sample.
double median_slope(const Readings& readings, double otherwise) {
  const auto& x = readings.samples;
  const auto& y = readings.nanoseconds;
  const std::size_t half = x.size() / 2;
  std::vector<double> slopes;
  for (std::size_t i = 0; i + half < x.size(); ++i) {
    const double run = x[i + half] - x[i];
    if (run > 0.0) slopes.push_back((y[i + half] - y[i]) / run);
  }
  return slopes.empty() ? otherwise : median(std::move(slopes));
}

struct Line {
  double offset = 0.0;
  double slope = 0.0;
};

std::vector<double> residuals(const Readings& readings, const Line& line) {
  std::vector<double> found;
  for (std::size_t i = 0; i < readings.samples.size(); ++i) {
    found.push_back(readings.nanoseconds[i] - line.offset - line.slope * readings.samples[i]);
  }
  return found;
}

Readings without_outliers(const Readings& readings, const Line& line, double smallest_limit) {
  auto sizes = residuals(readings, line);
  for (auto& size : sizes) size = std::abs(size);
  const double limit =
      std::max(kRejectBeyond * kDeviationPerMedianDeviation * median(sizes), smallest_limit);
  Readings kept{readings.origin, {}, {}};
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (sizes[i] > limit) continue;
    kept.samples.push_back(readings.samples[i]);
    kept.nanoseconds.push_back(readings.nanoseconds[i]);
  }
  return kept;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

Line least_squares(const Readings& readings) {
  const double x_mean = mean(readings.samples);
  const double y_mean = mean(readings.nanoseconds);
  double xx = 0.0;
  double xy = 0.0;
  for (std::size_t i = 0; i < readings.samples.size(); ++i) {
    const double x = readings.samples[i] - x_mean;
    xx += x * x;
    xy += x * (readings.nanoseconds[i] - y_mean);
  }
  return {y_mean - xy / xx * x_mean, xy / xx};
}

double standard_deviation(const std::vector<double>& deviations, std::size_t parameters) {
  if (deviations.size() <= parameters) return 0.0;
  double squares = 0.0;
  for (const double deviation : deviations) squares += deviation * deviation;
  return std::sqrt(squares / static_cast<double>(deviations.size() - parameters));
}

}  // namespace

Instant ClockFit::instant_of(std::int64_t at) const {
  return instant +
         Duration{std::llround(static_cast<double>(at - sample) * nanoseconds_per_sample)};
}

std::int64_t ClockFit::sample_at(Instant at) const {
  return sample +
         std::llround(static_cast<double>((at - instant).count()) / nanoseconds_per_sample);
}

std::optional<ClockFit> fit_clock(std::span<const ClockPair> pairs,
                                  Hertz nominal_rate,
                                  Duration shortest_for_drift) {
  if (pairs.empty()) return std::nullopt;
  const double nominal = kNanosecondsPerSecond / nominal_rate.count();
  const auto readings = relative(pairs);
  const double span = (readings.samples.back() - readings.samples.front()) * nominal;
  const bool drift_shows = span > 0.0 && span >= static_cast<double>(shortest_for_drift.count());

  const double slope = drift_shows ? median_slope(readings, nominal) : nominal;
  const Line middle{median(residuals(readings, {0.0, slope})), slope};
  const auto kept = without_outliers(readings, middle, nominal / 2.0);
  const auto line =
      drift_shows ? least_squares(kept) : Line{mean(residuals(kept, {0.0, nominal})), nominal};
  const auto deviation = standard_deviation(residuals(kept, line), drift_shows ? 2 : 1);
  return ClockFit{
      .sample = readings.origin.sample,
      .instant = readings.origin.instant + Duration{std::llround(line.offset)},
      .nanoseconds_per_sample = line.slope,
      .drift_ppm = (nominal / line.slope - 1.0) * 1e6,
      .residual = Duration{std::llround(deviation)},
      .count = kept.samples.size(),
      .rejected = pairs.size() - kept.samples.size(),
  };
}

ClockMap::ClockMap(Hertz nominal_rate, ClockMapOptions options)
    : nominal_rate_{nominal_rate}, options_{options} {}

void ClockMap::add(const ClockPair& pair) {
  if (!pairs_.empty() && pair.instant - pairs_.back().instant > options_.longest_gap) {
    forget_all_but(0);
  }
  renew_judge();
  notice_jump(pair);
  pairs_.push_back(pair);
  while (pairs_.size() > options_.most || pair.instant - pairs_.front().instant > options_.window) {
    pairs_.pop_front();
  }
  fitted_ = false;
}

void ClockMap::forget_all_but(std::size_t latest) {
  const auto forgotten = pairs_.size() - std::min(latest, pairs_.size());
  pairs_.erase(pairs_.begin(), pairs_.begin() + static_cast<std::ptrdiff_t>(forgotten));
  judge_.reset();
  late_ = early_ = 0;
  fitted_ = false;
}

void ClockMap::renew_judge() {
  constexpr std::size_t kRenewAfter = 256;
  ++since_judge_;
  const bool undisturbed = late_ == 0 && early_ == 0 && pairs_.size() >= options_.confirmations;
  if (!undisturbed || (judge_ && since_judge_ < kRenewAfter)) return;
  judge_ = fit();
  since_judge_ = 0;
}

void ClockMap::notice_jump(const ClockPair& pair) {
  if (!judge_) return;
  constexpr int kResiduals = 6;
  const auto off = pair.instant - judge_->instant_of(pair.sample);
  const auto limit = std::max(options_.jump, kResiduals * judge_->residual);
  late_ = off > limit ? late_ + 1 : 0;
  early_ = off < -limit ? early_ + 1 : 0;
  if (late_ < options_.confirmations && early_ < options_.confirmations) return;
  forget_all_but(options_.confirmations - 1);  // which lie after the jump, as does this one
  latest_jump_ = pairs_.empty() ? pair.sample : pairs_.front().sample;
  ++jumps_;
}

const std::optional<ClockFit>& ClockMap::fit() {
  if (!fitted_) {
    const std::vector<ClockPair> pairs{pairs_.begin(), pairs_.end()};
    fit_ = fit_clock(pairs, nominal_rate_, options_.shortest_for_drift);
    fitted_ = true;
  }
  return fit_;
}

}  // namespace bimodal::runner
