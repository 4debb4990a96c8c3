#include "synth/fitting/agreement.hpp"

#include <cassert>
#include <cmath>
#include <numeric>

namespace bimodal::synth {

namespace {

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

double Agreement::rmse() const {
  return std::sqrt(squares / static_cast<double>(instants));
}

double Agreement::rmse_scaled() const {
  return std::sqrt(squares_scaled / static_cast<double>(instants));
}

Agreement agreement(std::span<const double> predicted, std::span<const double> measured) {
  assert(!predicted.empty() && predicted.size() == measured.size());
  constexpr double kConstant = 1e-20;  // squares of what rounding leaves of a constant
  const double mean_predicted = mean(predicted);
  const double mean_measured = mean(measured);
  Agreement found{.instants = predicted.size()};
  double own = 0;
  double other = 0;
  double common = 0;
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    const double x = predicted[i] - mean_predicted;
    const double y = measured[i] - mean_measured;
    own += x * x;
    other += y * y;
    common += x * y;
    found.squares += (predicted[i] - measured[i]) * (predicted[i] - measured[i]);
  }
  const auto varies = [&](double squares, double middle) {
    return squares > kConstant * static_cast<double>(predicted.size()) * (1 + middle * middle);
  };
  const bool predicted_varies = varies(own, mean_predicted);
  found.gain = predicted_varies ? common / own : 0.0;
  found.offset = mean_measured - found.gain * mean_predicted;
  found.squares_scaled = other - found.gain * common;
  if (predicted_varies && varies(other, mean_measured)) {
    found.r = common / std::sqrt(own * other);
  }
  return found;
}

Agreement over_clips(std::span<const Agreement> clips) {
  Agreement all;
  double sum = 0;
  std::size_t defined = 0;
  for (const auto& clip : clips) {
    all.instants += clip.instants;
    all.squares += clip.squares;
    all.squares_scaled += clip.squares_scaled;
    all.offset += clip.offset / static_cast<double>(clips.size());
    all.gain += clip.gain / static_cast<double>(clips.size());
    if (!clip.r) continue;
    sum += *clip.r;
    ++defined;
  }
  if (defined > 0) all.r = sum / static_cast<double>(defined);
  return all;
}

}  // namespace bimodal::synth
