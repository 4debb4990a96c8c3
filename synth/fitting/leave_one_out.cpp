#include "synth/fitting/leave_one_out.hpp"

#include <cassert>
#include <limits>

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
    all.push_back(agreement(predicted(learnt, clips[out], learnt.talker), clips[out].values));
  }
  return all;
}

Chosen choose(std::span<const MeasuredClip> clips,
              const FitOptions& options,
              const Choice& choice,
              const std::function<void(const Chosen&)>& tell) {
  Chosen best;
  double best_r = -std::numeric_limits<double>::infinity();
  const auto is_better = [&](const FitOptions& tried) {
    Chosen one{.options = tried, .left_out = leave_one_out(clips, tried)};
    const double r = over_clips(one.left_out).r.value_or(-1);
    if (tell) tell(one);
    if (r <= best_r) return false;
    best_r = r;
    best = std::move(one);
    return true;
  };
  is_better(options);
  bool improves = true;
  while (improves) {
    improves = false;
    for (const double theta : choice.thetas_per_ms) {
      auto tried = best.options;
      tried.theta_per_ms = theta;
      if (tried.theta_per_ms != best.options.theta_per_ms) improves |= is_better(tried);
    }
    for (const double shrinkage : choice.shrinkages) {
      auto tried = best.options;
      tried.shrinkage = shrinkage;
      if (shrinkage != best.options.shrinkage) improves |= is_better(tried);
    }
    if (choice.thetas_per_ms.empty()) break;
  }
  return best;
}

}  // namespace bimodal::synth
