#pragma once

#include <span>
#include <vector>

#include "synth/fitting/fit_parameters.hpp"

namespace bimodal::synth {

/// What a clip shows of the model's value: an opening is max(0, F) times the talker's gain, a
/// position F plus the talker's offset. `talker` is the logarithm of the gain, or the offset.
[[nodiscard]] double shown(MeasureKind kind, double blended, double talker);

/// The squares whose sum a fit makes least, as functions of its parameters: for each measured value
/// (predicted - measured) / sd, and for each parameter that is shrunk shrinkage * value / spread.
class FitProblem {
 public:
  /// `clips` are borrowed and must outlive it; there is at least one.
  FitProblem(std::span<const MeasuredClip> clips, const FitOptions& options);

  [[nodiscard]] std::size_t parameter_count() const { return parameters_.count(); }

  [[nodiscard]] std::size_t residual_count() const { return residual_count_; }

  /// The standard deviation of all measured values; 1 if they are all alike.
  [[nodiscard]] double sd() const { return sd_; }

  [[nodiscard]] const FitParameters& parameters() const { return parameters_; }

  /// A talker's log gain, or offset in the measure's unit; 0 where talkers are alike.
  [[nodiscard]] double talker(std::size_t clip, std::span<const double> values) const;

  /// Residuals at `values` and, unless `jacobian` is empty, their derivatives: one row per
  /// residual, one column per parameter.
  void evaluate(std::span<const double> values,
                std::span<double> residuals,
                std::span<double> jacobian) const;

 private:
  void evaluate_clip(std::size_t clip,
                     std::span<const double> values,
                     std::span<double> residuals,
                     std::span<double> jacobian) const;

  std::span<const MeasuredClip> clips_;
  FitOptions options_;
  double mean_;
  double sd_;
  FitParameters parameters_;
  std::size_t residual_count_ = 0;
};

}  // namespace bimodal::synth
