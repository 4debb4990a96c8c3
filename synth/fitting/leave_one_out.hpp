#pragma once

#include <functional>
#include <span>
#include <vector>

#include "synth/fitting/agreement.hpp"
#include "synth/fitting/fit.hpp"

namespace bimodal::synth {

/// How well the fit of all other clips tells each clip, whose talker is unknown to it.
/// Precondition: there are at least two clips.
[[nodiscard]] std::vector<Agreement> leave_one_out(std::span<const MeasuredClip> clips,
                                                   const FitOptions& options);

/// What to try. Where `thetas_per_ms` is empty, theta is as the options say.
struct Choice {
  std::vector<double> shrinkages{0.25, 0.35, 0.5, 0.7, 1.0};
  std::vector<double> thetas_per_ms{.0075, .010, .0125, .015, .018, .022, .028, .035, .050};
};

/// Options, and how well they tell each clip that they have not seen.
struct Chosen {
  FitOptions options;
  std::vector<Agreement> left_out;
};

/// The shrinkage and theta whose left-out clips have the greatest mean r: first every theta is
/// tried, then every shrinkage with the best of them, and so on until nothing is better. The r of
/// what is chosen is a little too good, since the same clips chose it. `tell` hears of each trial;
/// it may be empty.
[[nodiscard]] Chosen choose(std::span<const MeasuredClip> clips,
                            const FitOptions& options,
                            const Choice& choice,
                            const std::function<void(const Chosen&)>& tell);

}  // namespace bimodal::synth
