#pragma once

#include <cstdint>
#include <optional>

namespace bimodal::analysis {

/// Sensitivity and bias of yes-no answers.
struct YesNo {
  double sensitivity = 0.0;  ///< d' = z(hits) - z(false alarms)
  double criterion = 0.0;    ///< c = -(z(hits) + z(false alarms)) / 2; positive: rather "no"
};

/// With 1/2 added to each count and 1 to each number of trials (log-linear; Hautus, 1995, Behav.
/// Res. Methods 27, 46-51), so that 0 and 1 do no harm. Absent without trials of either kind.
[[nodiscard]] std::optional<YesNo> yes_no(std::int64_t hits,
                                          std::int64_t signals,
                                          std::int64_t false_alarms,
                                          std::int64_t noises);

/// Proportion correct of an unbiased observer who chooses one of m alternatives: the integral of
/// phi(x - d') Phi(x)^(m - 1) (Green & Swets, 1966, Signal Detection Theory and Psychophysics). m
/// from 2.
[[nodiscard]] double proportion_of_choices(double sensitivity, int alternatives);

/// The d' at which that is the proportion correct; found by bracketing to 1e-10. Absent for a
/// proportion of 0 or 1. Below chance it is negative.
[[nodiscard]] std::optional<double> sensitivity_of_choices(double proportion, int alternatives);

/// Of counts, log-linear corrected towards chance: (correct + 1/m) / (trials + 1). Absent without
/// trials.
[[nodiscard]] std::optional<double> sensitivity_of_choices(std::int64_t correct,
                                                           std::int64_t trials,
                                                           int alternatives);

}  // namespace bimodal::analysis
