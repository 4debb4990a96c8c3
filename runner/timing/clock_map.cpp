#include "runner/timing/clock_map.hpp"

#include <algorithm>
#include <cmath>

namespace bimodal::runner {

namespace {

constexpr double kNanosecondsPerSecond = 1e9;
constexpr double kDeviationPerMedianDeviation = 1.4826;  // of a normal distribution
constexpr double kRejectBeyond = 4.0;                    // robust standard deviations

/// The upper median; values must not be empty. Orders them.
double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
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
  return ClockFitter{pairs.size()}.fit(pairs, nominal_rate, shortest_for_drift);
}

ClockFitter::ClockFitter(std::size_t most) {
  readings_.reserve(most);
  values_.reserve(most);
}

std::optional<ClockFit> ClockFitter::fit(std::span<const ClockPair> pairs,
                                         Hertz nominal_rate,
                                         Duration shortest_for_drift) {
  if (pairs.empty()) return std::nullopt;
  const double nominal = kNanosecondsPerSecond / nominal_rate.count();
  const auto& origin = pairs[pairs.size() / 2];
  readings_.clear();
  for (const auto& pair : pairs) {
    readings_.push_back({static_cast<double>(pair.sample - origin.sample),
                         static_cast<double>((pair.instant - origin.instant).count())});
  }
  const double span = (readings_.back().sample - readings_.front().sample) * nominal;
  const bool drift_shows = span > 0.0 && span >= static_cast<double>(shortest_for_drift.count());

  const double slope = drift_shows ? median_slope(nominal) : nominal;
  leave_out_far_ones({median_residual({0.0, slope}), slope}, nominal / 2.0);
  const auto line = drift_shows ? least_squares() : Line{mean_residual(nominal), nominal};
  return ClockFit{
      .sample = origin.sample,
      .instant = origin.instant + Duration{std::llround(line.offset)},
      .nanoseconds_per_sample = line.slope,
      .drift_ppm = (nominal / line.slope - 1.0) * 1e6,
      .residual = Duration{std::llround(standard_deviation(line, drift_shows ? 2 : 1))},
      .count = readings_.size(),
      .rejected = pairs.size() - readings_.size(),
  };
}

double ClockFitter::residual(const Reading& reading, const Line& line) {
  return reading.nanoseconds - line.offset - line.slope * reading.sample;
}

/// Of pairs half the readings apart; `otherwise` if none of them differ in their sample.
double ClockFitter::median_slope(double otherwise) {
  const std::size_t half = readings_.size() / 2;
  values_.clear();
  for (std::size_t i = 0; i + half < readings_.size(); ++i) {
    const auto& early = readings_[i];
    const auto& late = readings_[i + half];
    const double run = late.sample - early.sample;
    if (run > 0.0) values_.push_back((late.nanoseconds - early.nanoseconds) / run);
  }
  return values_.empty() ? otherwise : median(values_);
}

double ClockFitter::median_residual(const Line& line) {
  values_.clear();
  for (const auto& reading : readings_) values_.push_back(residual(reading, line));
  return median(values_);
}

void ClockFitter::leave_out_far_ones(const Line& line, double smallest_limit) {
  values_.clear();
  for (const auto& reading : readings_) values_.push_back(std::abs(residual(reading, line)));
  const double limit =
      std::max(kRejectBeyond * kDeviationPerMedianDeviation * median(values_), smallest_limit);
  std::erase_if(readings_,
                [&](const Reading& reading) { return std::abs(residual(reading, line)) > limit; });
}

ClockFitter::Line ClockFitter::least_squares() const {
  const auto count = static_cast<double>(readings_.size());
  double x_sum = 0.0;
  double y_sum = 0.0;
  for (const auto& reading : readings_) {
    x_sum += reading.sample;
    y_sum += reading.nanoseconds;
  }
  const double x_mean = x_sum / count;
  const double y_mean = y_sum / count;
  double xx = 0.0;
  double xy = 0.0;
  for (const auto& reading : readings_) {
    const double x = reading.sample - x_mean;
    xx += x * x;
    xy += x * (reading.nanoseconds - y_mean);
  }
  return {y_mean - xy / xx * x_mean, xy / xx};
}

double ClockFitter::mean_residual(double slope) const {
  double sum = 0.0;
  for (const auto& reading : readings_) sum += residual(reading, {0.0, slope});
  return sum / static_cast<double>(readings_.size());
}

double ClockFitter::standard_deviation(const Line& line, std::size_t parameters) const {
  if (readings_.size() <= parameters) return 0.0;
  double squares = 0.0;
  for (const auto& reading : readings_) {
    squares += residual(reading, line) * residual(reading, line);
  }
  return std::sqrt(squares / static_cast<double>(readings_.size() - parameters));
}

ClockMap::ClockMap(Hertz nominal_rate, ClockMapOptions options)
    : nominal_rate_{nominal_rate}, options_{options}, fitter_{options.most} {
  pairs_.reserve(2 * options.most);
}

void ClockMap::add(const ClockPair& pair) {
  if (!pairs().empty() && pair.instant - pairs().back().instant > options_.longest_gap) {
    forget_all_but(0);
    note_jump(pair.sample);
  }
  renew_judge();
  notice_jump(pair);
  if (pairs_.size() == pairs_.capacity()) {
    pairs_.erase(pairs_.begin(), pairs_.begin() + static_cast<std::ptrdiff_t>(first_));
    first_ = 0;
  }
  pairs_.push_back(pair);
  while (pairs().size() > options_.most ||
         pair.instant - pairs().front().instant > options_.window) {
    ++first_;
  }
  fitted_ = false;
}

void ClockMap::forget_all_but(std::size_t latest) {
  first_ = pairs_.size() - std::min(latest, pairs().size());
  judge_.reset();
  late_ = early_ = 0;
  fitted_ = false;
}

void ClockMap::renew_judge() {
  constexpr std::size_t kRenewAfter = 256;
  ++since_judge_;
  const bool undisturbed = late_ == 0 && early_ == 0 && pairs().size() >= options_.confirmations;
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
  note_jump(pairs().empty() ? pair.sample : pairs().front().sample);
}

void ClockMap::note_jump(std::int64_t sample) {
  latest_jump_ = sample;
  ++jumps_;
}

const std::optional<ClockFit>& ClockMap::fit() {
  if (!fitted_) {
    fit_ = fitter_.fit(pairs(), nominal_rate_, options_.shortest_for_drift);
    fitted_ = true;
  }
  return fit_;
}

}  // namespace bimodal::runner
