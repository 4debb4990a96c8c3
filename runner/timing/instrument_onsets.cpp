#include "runner/timing/instrument_onsets.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bimodal::runner {

namespace {

constexpr double kDeviationPerMedianDeviation = 1.4826;  // of a normal distribution
constexpr double kLeastDeviations = 8.0;
constexpr double kLeastStep = 0.002;  // of full scale
constexpr double kPartOfLargest = 1.0 / 3.0;

struct Rest {
  double level = 0.0;
  double deviation = 0.0;
};

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Rest rest_of(std::span<const float> signal) {
  std::vector<double> values(signal.begin(), signal.end());
  Rest rest{.level = median(values)};
  for (auto& value : values) value = std::abs(value - rest.level);
  rest.deviation = kDeviationPerMedianDeviation * median(values);
  return rest;
}

bool stands_out(double step, const Rest& rest) {
  return std::abs(step) >= std::max(kLeastDeviations * rest.deviation, kLeastStep);
}

}  // namespace

std::optional<double> onset_of_light(std::span<const float> signal,
                                     std::size_t rest,
                                     std::size_t lasting) {
  if (rest == 0 || signal.size() <= rest + lasting) return std::nullopt;
  const auto dark = rest_of(signal.first(rest));
  const auto farthest = *std::ranges::max_element(
      signal, {}, [&](float sample) { return std::abs(static_cast<double>(sample) - dark.level); });
  const double step = static_cast<double>(farthest) - dark.level;
  if (!stands_out(step, dark)) return std::nullopt;
  const auto height = [&](std::size_t at) {
    return (static_cast<double>(signal[at]) - dark.level) / step;
  };
  std::size_t beyond = 0;
  for (std::size_t at = 0; at < signal.size(); ++at) {
    beyond = height(at) >= 0.5 ? beyond + 1 : 0;
    if (beyond < std::max<std::size_t>(lasting, 1)) continue;
    const auto first = at + 1 - beyond;
    if (first == 0) return std::nullopt;  // it did not begin here
    const double before = height(first - 1);
    return static_cast<double>(first - 1) + (0.5 - before) / (height(first) - before);
  }
  return std::nullopt;
}

std::optional<double> onset_of_sound(std::span<const float> signal, std::size_t rest) {
  if (rest == 0 || signal.size() <= rest) return std::nullopt;
  const auto silence = rest_of(signal.first(rest));
  const auto magnitude = [&](float sample) {
    return std::abs(static_cast<double>(sample) - silence.level);
  };
  const auto largest = magnitude(*std::ranges::max_element(signal, {}, magnitude));
  if (!stands_out(largest, silence)) return std::nullopt;
  const auto first = std::ranges::find_if(
      signal, [&](float sample) { return magnitude(sample) >= kPartOfLargest * largest; });
  return static_cast<double>(first - signal.begin());
}

}  // namespace bimodal::runner
