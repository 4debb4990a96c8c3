#include "synth/fitting/leave_one_out.hpp"

#include <cassert>
#include <limits>
#include <set>
#include <utility>

namespace bimodal::synth {

std::vector<Agreement> leave_one_out(std::span<const MeasuredClip> clips,
                                     const FitOptions& options) {
  assert(clips.size() >= 2);
  std::vector<Agreement> all;
  all.reserve(clips.size());
  for (std::size_t out = 0; out < clips.size(); ++out) {
    std::vector<MeasuredClip> others;
    others.reserve(clips.size() - 1);
    for (std::size_t i = 0; i < clips.size(); ++i) {
      if (i != out) others.push_back(clips[i]);
    }
    const auto learnt = fit(others, options);
    all.push_back(agreement(predicted(learnt, clips[out], 0), clips[out].values));
  }
  return all;
}

Chosen choose(std::span<const MeasuredClip> clips,
              const FitOptions& options,
              const Choice& choice,
              const std::function<void(const Chosen&)>& tell) {
  Chosen best;
  double best_r = -std::numeric_limits<double>::infinity();
  std::set<std::pair<double, double>> tried;
  const auto is_better = [&](const FitOptions& one) {
    if (!tried.emplace(one.theta_per_ms.value_or(0), one.shrinkage).second) return false;
    Chosen told{.options = one, .left_out = leave_one_out(clips, one)};
    const double r = over_clips(told.left_out).r.value_or(-1);
    if (tell) tell(told);
    if (r <= best_r) return false;
    best_r = r;
    best = std::move(told);
    return true;
  };
  bool improves = is_better(options);
  while (improves) {
    improves = false;
    for (const double theta : choice.thetas_per_ms) {
      auto one = best.options;
      one.theta_per_ms = theta;
      improves |= is_better(one);
    }
    for (const double shrinkage : choice.shrinkages) {
      auto one = best.options;
      one.shrinkage = shrinkage;
      improves |= is_better(one);
    }
  }
  return best;
}

}  // namespace bimodal::synth
