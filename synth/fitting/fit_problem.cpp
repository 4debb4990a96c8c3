#include "synth/fitting/fit_problem.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace bimodal::synth {

namespace {

double mean_of(std::span<const MeasuredClip> clips) {
  double sum = 0;
  std::size_t count = 0;
  for (const auto& clip : clips) {
    for (const double value : clip.values) sum += value;
    count += clip.values.size();
  }
  return sum / static_cast<double>(count);
}

double sd_of(std::span<const MeasuredClip> clips, double mean) {
  double sum = 0;
  std::size_t count = 0;
  for (const auto& clip : clips) {
    for (const double value : clip.values) sum += (value - mean) * (value - mean);
    count += clip.values.size();
  }
  const double sd = std::sqrt(sum / static_cast<double>(count));
  return sd > 0 ? sd : 1.0;
}

}  // namespace

double shown(MeasureKind kind, double blended, double talker) {
  if (kind == MeasureKind::Position) return blended + talker;
  return std::exp(talker) * std::max(0.0, blended);
}

FitProblem::FitProblem(std::span<const MeasuredClip> clips, const FitOptions& options)
    : clips_{clips},
      options_{options},
      mean_{mean_of(clips)},
      sd_{sd_of(clips, mean_)},
      parameters_{clips, options, mean_, sd_} {
  for (const auto& clip : clips) residual_count_ += clip.values.size();
  residual_count_ += static_cast<std::size_t>(std::ranges::count_if(
      parameters_.spread(), [](const auto& spread) { return spread.has_value(); }));
}

double FitProblem::talker(std::size_t clip, std::span<const double> values) const {
  const double own = parameters_.talker(clip, values);
  return options_.kind == MeasureKind::Opening ? own : sd_ * own;
}

void FitProblem::evaluate_clip(std::size_t clip,
                               std::span<const double> values,
                               std::span<double> residuals,
                               std::span<double> jacobian) const {
  const auto& spoken = clips_[clip].spoken;
  const auto& times = clips_[clip].time_ms;
  std::vector<PartDynamics> asked;
  asked.reserve(spoken.size());
  for (const auto& one : spoken) asked.push_back(parameters_.dynamics(one.part, values));
  std::vector<PartDynamics> gradient(spoken.size());
  const double own = talker(clip, values);
  const bool opens = options_.kind == MeasureKind::Opening;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double value = blend_gradient(spoken, asked, times[i], gradient);
    const double predicted = shown(options_.kind, value, own);
    residuals[i] = (predicted - clips_[clip].values[i]) / sd_;
    if (jacobian.empty()) continue;
    const auto row = jacobian.subspan(i * parameters_.count(), parameters_.count());
    const double by_value = !opens ? 1.0 : (value > 0 ? std::exp(own) : 0.0);
    for (std::size_t k = 0; k < spoken.size(); ++k) {
      parameters_.add_slopes(spoken[k].part, gradient[k], by_value / sd_, row);
    }
    parameters_.add_talker_slope(clip, opens ? predicted / sd_ : 1.0, row);
  }
}

void FitProblem::evaluate(std::span<const double> values,
                          std::span<double> residuals,
                          std::span<double> jacobian) const {
  assert(values.size() == parameter_count() && residuals.size() == residual_count_);
  const auto columns = parameter_count();
  std::ranges::fill(jacobian, 0.0);
  std::size_t row = 0;
  for (std::size_t clip = 0; clip < clips_.size(); ++clip) {
    const auto rows = clips_[clip].values.size();
    evaluate_clip(clip,
                  values,
                  residuals.subspan(row, rows),
                  jacobian.empty() ? jacobian : jacobian.subspan(row * columns, rows * columns));
    row += rows;
  }
  const auto spread = parameters_.spread();
  for (std::size_t i = 0; i < columns; ++i) {
    if (!spread[i]) continue;
    const double weight = options_.shrinkage / *spread[i];
    residuals[row] = weight * values[i];
    if (!jacobian.empty()) jacobian[row * columns + i] = weight;
    ++row;
  }
}

}  // namespace bimodal::synth
