#include "analysis/statistics/correlation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace bimodal::analysis {

namespace {

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Places of the values, the least first.
std::vector<std::size_t> sorted_places(std::span<const double> values) {
  std::vector<std::size_t> places(values.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::ranges::stable_sort(places, {}, [&](std::size_t place) { return values[place]; });
  return places;
}

}  // namespace

std::optional<double> pearson(std::span<const double> xs, std::span<const double> ys) {
  assert(xs.size() == ys.size());
  if (xs.size() < 2) return std::nullopt;
  const double mean_x = mean(xs);
  const double mean_y = mean(ys);
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    xx += (xs[i] - mean_x) * (xs[i] - mean_x);
    yy += (ys[i] - mean_y) * (ys[i] - mean_y);
    xy += (xs[i] - mean_x) * (ys[i] - mean_y);
  }
  if (xx <= 0.0 || yy <= 0.0) return std::nullopt;
  return std::clamp(xy / std::sqrt(xx * yy), -1.0, 1.0);
}

std::vector<double> ranks(std::span<const double> values) {
  const auto places = sorted_places(values);
  std::vector<double> ranked(values.size());
  for (std::size_t first = 0; first < places.size();) {
    auto behind = first;
    while (behind < places.size() && values[places[behind]] <= values[places[first]]) ++behind;
    const double shared = static_cast<double>(first + 1 + behind) / 2.0;
    for (; first < behind; ++first) ranked[places[first]] = shared;
  }
  return ranked;
}

std::optional<double> spearman(std::span<const double> xs, std::span<const double> ys) {
  return pearson(ranks(xs), ranks(ys));
}

double spearman_brown(double r) {
  return 2.0 * r / (1.0 + r);
}

std::vector<double> false_discovery_rates(std::span<const double> p_values) {
  const auto places = sorted_places(p_values);
  std::vector<double> adjusted(p_values.size());
  const auto all = static_cast<double>(p_values.size());
  double least = 1.0;
  for (std::size_t i = places.size(); i-- > 0;) {
    least = std::min(least, p_values[places[i]] * all / static_cast<double>(i + 1));
    adjusted[places[i]] = least;
  }
  return adjusted;
}

}  // namespace bimodal::analysis
