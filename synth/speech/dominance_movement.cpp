#include "synth/speech/dominance_movement.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace bimodal::synth {

namespace {

/// The order of the claims by peak; of equal ones the first first.
std::vector<std::size_t> order_of(const std::vector<Claim>& claims) {
  std::vector<std::size_t> order(claims.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (std::ranges::is_sorted(claims, {}, &Claim::peak)) return order;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return claims[i].peak; });
  return order;
}

}  // namespace

double DominanceMovement::Peak::log_weight(double at_ms) const {
  const bool is_plain = dominance.exponent == 1.0 && dominance.form == DominanceForm::Exponential &&
                        dominance.inflection_ms == Dominance::kNoInflection;
  if (!is_plain) return dominance.log_at(Milliseconds{at_ms - time_ms});
  const double offset = at_ms - time_ms;
  return log_alpha +
         (offset <= 0 ? dominance.theta_before * offset : -dominance.theta_after * offset);
}

DominanceMovement::DominanceMovement(const ControlClaims& claims) {
  for (std::size_t control = 0; control < claims.size(); ++control) {
    const auto& asked = claims[control];
    assert(!asked.empty());
    const auto [lowest, highest] = std::ranges::minmax(asked, {}, &Claim::target);
    const Track track{.control = control, .lowest = lowest.target, .highest = highest.target};
    if (track.lowest == track.highest) {
      constant_.push_back(track);
      continue;
    }
    const auto order = order_of(asked);
    std::vector<double> targets;
    targets.reserve(asked.size());
    for (const auto i : order) targets.push_back(asked[i].target);
    auto same = std::ranges::find_if(channels_, [&](const Channel& channel) {
      const auto is_claimed = [](const Peak& peak, const Claim& claim) {
        return peak.time_ms == claim.peak.count() && peak.dominance == claim.dominance;
      };
      return channel.tracks.size() < kMostTracks &&
             std::ranges::equal(
                 channel.peaks, order, is_claimed, {}, [&](std::size_t i) -> const Claim& {
                   return asked[i];
                 });
    });
    if (same == channels_.end()) {
      channels_.emplace_back();
      same = channels_.end() - 1;
      same->peaks.reserve(asked.size());
      for (const auto i : order) {
        same->peaks.push_back({.time_ms = asked[i].peak.count(),
                               .log_alpha = std::log(asked[i].dominance.alpha),
                               .dominance = asked[i].dominance});
      }
    }
    same->tracks.push_back(track);
    same->targets.push_back(std::move(targets));
  }
  for (auto& channel : channels_) {
    add_bounds(channel);
    add_sums(channel);
  }
}

void DominanceMovement::add_sums(Channel& channel) {
  std::vector<Claim> claims;
  claims.reserve(channel.peaks.size());
  for (const auto& peak : channel.peaks) {
    claims.push_back({.peak = Milliseconds{peak.time_ms}, .dominance = peak.dominance});
  }
  channel.sums = DominanceSums::of(claims, channel.targets);
}

void DominanceMovement::add_bounds(Channel& channel) {
  const auto& peaks = channel.peaks;
  constexpr Bound kNothing{.log_alpha = -std::numeric_limits<double>::infinity(),
                           .theta = std::numeric_limits<double>::infinity()};
  channel.earlier.resize(peaks.size());
  channel.later.resize(peaks.size());
  Bound bound = kNothing;
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    const auto& dominance = peaks[i].dominance;
    channel.is_damped = channel.is_damped || dominance.form == DominanceForm::CriticallyDamped;
    bound.log_alpha = std::max(bound.log_alpha, peaks[i].log_alpha);
    bound.theta = std::min(bound.theta, dominance.exponent == 1.0 ? dominance.theta_after : 0.0);
    channel.earlier[i] = bound;
  }
  bound = kNothing;
  for (std::size_t i = peaks.size(); i-- > 0;) {
    const auto& dominance = peaks[i].dominance;
    double theta = dominance.exponent == 1.0 ? dominance.theta_before : 0.0;
    if (dominance.inflection_ms != Dominance::kNoInflection) {
      theta = std::min(theta, dominance.theta_early);
    }
    bound.log_alpha = std::max(bound.log_alpha, peaks[i].log_alpha);
    bound.theta = std::min(bound.theta, theta);
    channel.later[i] = bound;
  }
}

DominanceMovement::Window DominanceMovement::window(const Channel& channel, double time_ms) {
  const auto& peaks = channel.peaks;
  const auto after = std::ranges::lower_bound(peaks, time_ms, {}, &Peak::time_ms);
  const auto middle = static_cast<std::size_t>(after - peaks.begin());
  Window window{
      .first = middle, .last = middle, .largest = -std::numeric_limits<double>::infinity()};
  const auto counts = [&](const Bound& bound, double distance) {
    const double x = bound.theta * distance;
    const double fall = channel.is_damped ? std::log1p(x) - x : -x;
    return bound.log_alpha + fall >= window.largest - kCut;
  };
  while (window.last < peaks.size() &&
         counts(channel.later[window.last], peaks[window.last].time_ms - time_ms)) {
    window.largest = std::max(window.largest, peaks[window.last].log_weight(time_ms));
    ++window.last;
  }
  while (window.first > 0 &&
         counts(channel.earlier[window.first - 1], time_ms - peaks[window.first - 1].time_ms)) {
    window.largest = std::max(window.largest, peaks[window.first - 1].log_weight(time_ms));
    --window.first;
  }
  return window;
}

double DominanceMovement::weigh(const Channel& channel, double time_ms, std::span<double> sums) {
  const auto counted = window(channel, time_ms);
  std::ranges::fill(sums, 0.0);
  double total = 0;
  for (std::size_t i = counted.first; i < counted.last; ++i) {
    const double log_weight = channel.peaks[i].log_weight(time_ms) - counted.largest;
    if (log_weight < -kCut) continue;
    // Divided by the largest, so that they stay meaningful where every dominance underflows.
    const double weight = std::exp(log_weight);
    total += weight;
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += weight * channel.targets[k][i];
  }
  return total;
}

void DominanceMovement::at(Milliseconds time, std::span<double> values) const {
  constexpr double kUnderflown = 1e-200;  // far above where doubles lose digits
  std::array<double, kMostTracks> places{};
  for (const auto& track : constant_) values[track.control] = track.lowest;
  for (const auto& channel : channels_) {
    const auto sums = std::span{places}.first(channel.tracks.size());
    double total = channel.sums ? channel.sums->at(time.count(), sums) : 0;
    if (total < kUnderflown) total = weigh(channel, time.count(), sums);
    for (std::size_t k = 0; k < sums.size(); ++k) {
      const auto& track = channel.tracks[k];
      values[track.control] = std::clamp(sums[k] / total, track.lowest, track.highest);
    }
  }
}

}  // namespace bimodal::synth
