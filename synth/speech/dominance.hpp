#pragma once

#include <span>

#include "stimuli/base/quantity.hpp"

namespace bimodal::synth {

/// How strongly, and for how long, one speech segment claims one control of the face.
///
/// Cohen, M. M. & Massaro, D. W. (1993). Modeling coarticulation in synthetic visual speech.
/// In N. Magnenat Thalmann & D. Thalmann (Eds.), Models and Techniques in Computer Animation
/// (pp. 139-156). Springer. Equations 1 to 3; symbols below are the paper's.
struct Dominance {
  double alpha = 1.0;         ///< magnitude: height of the peak, > 0
  double theta_before = 0.0;  ///< rate before the peak (anticipation, the paper's tau >= 0), 1/ms^c
  double theta_after = 0.0;   ///< rate after the peak (carry-over, tau < 0), 1/ms^c, >= 0
  double exponent = 1.0;      ///< c, > 0; 1 gives the paper's negative exponential

  /// Dominance at `offset` from the peak (negative: before it; this is minus the paper's tau). In
  /// [0, alpha]; 0 only where the exponential underflows.
  [[nodiscard]] double at(Duration offset) const;

  /// Natural logarithm of the dominance, finite where at() underflows.
  [[nodiscard]] double log_at(Duration offset) const;

  bool operator==(const Dominance&) const = default;
};

/// One segment's claim on one control.
struct Claim {
  Duration peak{};    ///< instant of full dominance, from utterance start: t_c + t_o
  double target = 0;  ///< the value that the segment asks for, in the control's own unit
  Dominance dominance;
};

/// The control's value at `time` (equation 6): the mean of all targets, weighted by dominance.
/// Precondition: `claims` is not empty. The result never leaves the range of the targets, and is
/// defined at any distance from the peaks, also where every dominance underflows.
[[nodiscard]] double blend(std::span<const Claim> claims, Duration time);

}  // namespace bimodal::synth
