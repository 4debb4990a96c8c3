#include "synth/speech/dominance_sums.hpp"

#include <algorithm>
#include <cmath>

namespace bimodal::synth {

namespace {

bool is_plain(const Dominance& dominance) {
  return dominance.exponent == 1.0 && dominance.form == DominanceForm::Exponential &&
         dominance.inflection_ms == Dominance::kNoInflection;
}

double rate(const Claim& claim, bool is_earlier) {
  return is_earlier ? claim.dominance.theta_after : claim.dominance.theta_before;
}

}  // namespace

std::optional<DominanceSums> DominanceSums::of(std::span<const Claim> claims,
                                               std::span<const std::vector<double>> targets) {
  DominanceSums made;
  made.stride_ = 1 + targets.size();
  for (const auto& claim : claims) {
    if (!is_plain(claim.dominance)) return std::nullopt;
    made.peaks_.push_back(claim.peak.count());
    for (auto* const side : {&made.earlier_, &made.later_}) {
      const double theta = rate(claim, side == &made.earlier_);
      if (std::ranges::find(side->rates, theta) == side->rates.end()) side->rates.push_back(theta);
    }
    if (std::max(made.earlier_.rates.size(), made.later_.rates.size()) > kMostRates) {
      return std::nullopt;
    }
  }
  made.add_up(made.earlier_, claims, targets, true);
  made.add_up(made.later_, claims, targets, false);
  return made;
}

void DominanceSums::add_up(Side& side,
                           std::span<const Claim> claims,
                           std::span<const std::vector<double>> targets,
                           bool is_earlier) {
  const auto count = claims.size();
  const auto row = side.rates.size() * stride_;
  side.sums.assign(count * row, 0.0);
  for (std::size_t step = 0; step < count; ++step) {
    const auto i = is_earlier ? step : count - 1 - step;
    auto* const here = side.sums.data() + i * row;
    if (step > 0) {
      const auto last = is_earlier ? i - 1 : i + 1;
      const auto* const there = side.sums.data() + last * row;
      for (std::size_t r = 0; r < side.rates.size(); ++r) {
        const double fall = std::exp(-side.rates[r] * std::abs(peaks_[i] - peaks_[last]));
        for (std::size_t k = 0; k < stride_; ++k) {
          here[r * stride_ + k] = fall * there[r * stride_ + k];
        }
      }
    }
    const auto own = std::ranges::find(side.rates, rate(claims[i], is_earlier));
    auto* const sums = here + static_cast<std::size_t>(own - side.rates.begin()) * stride_;
    const double alpha = claims[i].dominance.alpha;
    sums[0] += alpha;
    for (std::size_t k = 1; k < stride_; ++k) sums[k] += alpha * targets[k - 1][i];
  }
}

double DominanceSums::add(const Side& side,
                          std::size_t peak,
                          double distance_ms,
                          std::span<double> sums) const {
  double total = 0;
  const auto* from = side.sums.data() + peak * side.rates.size() * stride_;
  for (const double theta : side.rates) {
    if (from[0] > 0) {
      const double fall = theta > 0 ? std::exp(-theta * distance_ms) : 1.0;
      total += fall * from[0];
      for (std::size_t k = 1; k < stride_; ++k) sums[k - 1] += fall * from[k];
    }
    from += stride_;
  }
  return total;
}

double DominanceSums::at(double time_ms, std::span<double> sums) const {
  const auto next =
      static_cast<std::size_t>(std::ranges::lower_bound(peaks_, time_ms) - peaks_.begin());
  std::ranges::fill(sums, 0.0);
  double total = 0;
  if (next < peaks_.size()) total += add(later_, next, peaks_[next] - time_ms, sums);
  if (next > 0) total += add(earlier_, next - 1, time_ms - peaks_[next - 1], sums);
  return total;
}

}  // namespace bimodal::synth
