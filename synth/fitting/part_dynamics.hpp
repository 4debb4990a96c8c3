#pragma once

#include <span>
#include <vector>

#include "synth/fitting/part.hpp"

namespace bimodal::synth {

/// What a part asks of a measure, in the numbers that are fitted: alpha and theta by their natural
/// logarithms, so that they stay positive. The model is that of Dominance with c = 1.
struct PartDynamics {
  double target = 0;            ///< in the measure's unit
  double log_alpha = 0;         ///< of alpha
  double log_theta_before = 0;  ///< of theta in 1/ms, before the peak
  double log_theta_after = 0;
  double offset_ms = 0;  ///< t_o: peak of dominance, counted from the part's centre

  bool operator==(const PartDynamics&) const = default;
};

/// The measure at `time_ms`, F = sum(D T) / sum(D), of parts of which `asked` has one each.
/// Precondition: there is at least one part.
[[nodiscard]] double blended(std::span<const SpokenPart> spoken,
                             std::span<const PartDynamics> asked,
                             double time_ms);

/// The same, and its derivatives by the numbers of each part, into `gradient`, one per part. With
/// D = exp(log_alpha - theta |tau|), tau = centre + offset - time and p = D / sum(D):
///   dF/dT = p                                  dF/dlog_alpha = p (T - F)
///   dF/dlog_theta = -theta |tau| p (T - F)     on the side where `time_ms` lies, else 0
///   dF/doffset = -theta p (T - F) for tau >= 0, +theta p (T - F) for tau < 0
double blend_gradient(std::span<const SpokenPart> spoken,
                      std::span<const PartDynamics> asked,
                      double time_ms,
                      std::span<PartDynamics> gradient);

}  // namespace bimodal::synth
