#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "stimuli/base/quantity.hpp"

namespace bimodal::synth {

/// How dominance falls with the distance from its peak.
enum class DominanceForm : std::uint8_t {
  Exponential,       ///< D = alpha exp(-x): equations 1 to 3
  CriticallyDamped,  ///< D = alpha exp(-x) (1 + x): equation 7, level at the peak
};

/// How strongly, and for how long, one speech segment claims one control of the face.
///
/// Cohen, M. M. & Massaro, D. W. (1993). Modeling coarticulation in synthetic visual speech.
/// In N. Magnenat Thalmann & D. Thalmann (Eds.), Models and Techniques in Computer Animation
/// (pp. 139-156). Springer. Equations 1 to 3 and 7; symbols below are the paper's. Its x is theta
/// times the distance in ms to the power c; where theta changes on the way (the paper's figures 9
/// and 10), x is the integral of theta over the distance, so that dominance has no jump.
struct Dominance {
  double alpha = 1.0;         ///< magnitude: height of the peak, > 0
  double theta_before = 0.0;  ///< rate before the peak (anticipation, the paper's tau >= 0), 1/ms^c
  double theta_after = 0.0;   ///< rate after the peak (carry-over, tau < 0), 1/ms^c, >= 0
  double exponent = 1.0;      ///< c, > 0; 1 gives the paper's negative exponential
  DominanceForm form = DominanceForm::Exponential;
  /// Earlier than this before the peak, in ms, the rate is `theta_early` instead of `theta_before`;
  /// infinite: never. Precondition where it is finite: not negative, and exponent is 1.
  double inflection_ms = kNoInflection;
  double theta_early = 0.0;  ///< 1/ms, >= 0

  static constexpr double kNoInflection = std::numeric_limits<double>::infinity();

  /// Dominance at `offset` from the peak (negative: before it; this is minus the paper's tau). In
  /// [0, alpha]; 0 only where the exponential underflows.
  [[nodiscard]] double at(Milliseconds offset) const;

  /// Natural logarithm of the dominance, finite where at() underflows.
  [[nodiscard]] double log_at(Milliseconds offset) const;

  bool operator==(const Dominance&) const = default;
};

/// One segment's claim on one control.
struct Claim {
  Milliseconds peak{};  ///< instant of full dominance, from utterance start: t_c + t_o
  double target = 0;    ///< the value that the segment asks for, in the control's own unit
  Dominance dominance;
  std::size_t segment = 0;  ///< which of the utterance's segments makes it

  bool operator==(const Claim&) const = default;
};

/// The control's value at `time` (equation 6): the mean of all targets, weighted by dominance.
/// Precondition: `claims` is not empty. The result never leaves the range of the targets, and is
/// defined at any distance from the peaks, also where every dominance underflows. This is the
/// model's definition in code; DominanceMovement computes the same, faster.
[[nodiscard]] double blend(std::span<const Claim> claims, Milliseconds time);

}  // namespace bimodal::synth
