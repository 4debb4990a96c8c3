#include "runner/timing/moments.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "stimuli/base/milliseconds.hpp"

namespace bimodal::runner {

namespace {

/// The smallest of 1, 2 and 5 times a power of ten that is at least `width`.
double round_width(double width) {
  const double decade = std::pow(10.0, std::floor(std::log10(width)));
  for (const double times : {1.0, 2.0, 5.0}) {
    if (times * decade >= width * (1.0 - 1e-9)) return times * decade;
  }
  return 10.0 * decade;
}

std::int64_t bin_of(double value, double width) {
  return static_cast<std::int64_t>(std::floor(value / width + 1e-9));
}

}  // namespace

Moments moments_of(std::span<const Duration> durations) {
  if (durations.empty()) return {};
  std::vector<double> values(durations.size());
  std::ranges::transform(durations, values.begin(), milliseconds);
  std::ranges::sort(values);
  Moments moments{
      .count = values.size(),
      .smallest_ms = values.front(),
      .largest_ms = values.back(),
      .largest_magnitude_ms = std::max(std::abs(values.front()), std::abs(values.back()))};
  const auto half = values.size() / 2;
  moments.median_ms =
      values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
  for (const double value : values) moments.mean_ms += value;
  moments.mean_ms /= static_cast<double>(values.size());
  if (values.size() < 2) return moments;
  double squares = 0.0;
  for (const double value : values) squares += std::pow(value - moments.mean_ms, 2);
  moments.deviation_ms = std::sqrt(squares / static_cast<double>(values.size() - 1));
  return moments;
}

Histogram histogram_of(std::span<const Duration> durations, std::size_t most) {
  assert(most >= 2);
  if (durations.empty()) return {};
  const auto [smallest, largest] = std::ranges::minmax(durations);
  const double low = milliseconds(smallest);
  const double high = milliseconds(largest);
  constexpr double kFinest = 0.01;
  double width = round_width(std::max((high - low) / static_cast<double>(most), kFinest));
  while (bin_of(high, width) - bin_of(low, width) >= static_cast<std::int64_t>(most)) {
    width = round_width(1.5 * width);
  }
  Histogram histogram{.width_ms = width, .bins = {}};
  const auto first = bin_of(low, width);
  for (auto bin = first; bin <= bin_of(high, width); ++bin) {
    histogram.bins.push_back({static_cast<double>(bin) * width, 0});
  }
  for (const auto duration : durations) {
    ++histogram.bins[static_cast<std::size_t>(bin_of(milliseconds(duration), width) - first)].count;
  }
  return histogram;
}

std::string draw(const Histogram& histogram, std::size_t columns) {
  if (histogram.bins.empty()) return {};
  const auto fullest = std::ranges::max(histogram.bins, {}, &Bin::count).count;
  const int decimals =
      std::max(0, static_cast<int>(std::ceil(-std::log10(histogram.width_ms) - 1e-9)));
  std::string text;
  for (const auto& bin : histogram.bins) {
    const auto length = (bin.count * columns + fullest - 1) / fullest;
    text += fmt::format("{:>+9.{}f} ms |{:<{}} {}\n",
                        bin.from_ms,
                        decimals,
                        std::string(length, '#'),
                        columns,
                        bin.count);
  }
  return text;
}

}  // namespace bimodal::runner
