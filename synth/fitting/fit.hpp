#pragma once

#include <span>
#include <vector>

#include "synth/fitting/fit_options.hpp"
#include "synth/fitting/part_dynamics.hpp"

namespace bimodal::synth {

/// A measure's targets and dominance, learnt from clips.
struct Fit {
  MeasureKind kind = MeasureKind::Position;
  std::vector<PartDynamics> dynamics;  ///< of every part of parts()
  std::vector<std::size_t> tokens;     ///< of each; 0: what its class or all parts say
  /// Per clip, log gain or offset (see shown); their mean is 0, which is for somebody unknown.
  std::vector<double> talkers;
  double cost = 0;  ///< half the sum of the squares (FitProblem)
  int steps = 0;    ///< of the minimiser
  bool converged = false;
};

/// Makes the sum of squares of FitProblem least, by Levenberg and Marquardt's method (Ceres, dense
/// QR, analytic derivatives), from equal targets, alphas of 1 and no offsets. Deterministic.
/// Preconditions: there is at least one clip; shrinkage is not negative.
[[nodiscard]] Fit fit(std::span<const MeasuredClip> clips, const FitOptions& options);

/// The measure that a fit tells for what is said in a clip, at the clip's instants.
[[nodiscard]] std::vector<double> predicted(const Fit& fit,
                                            const MeasuredClip& clip,
                                            double talker);

}  // namespace bimodal::synth
