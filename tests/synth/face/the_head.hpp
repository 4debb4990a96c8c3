#pragma once

#include "stimuli/base/asset.hpp"
#include "synth/face/head.hpp"

namespace bimodal::synth {

/// The project's own head, read once per test program.
inline const Head& the_head() {
  static const Head head{asset("synth/assets/head")};
  return head;
}

struct Setting {
  Control control;
  double amount;
};

/// Neutral but for `settings`.
inline Pose pose_of(std::initializer_list<Setting> settings) {
  Pose pose = neutral_pose();
  for (const auto& [control, amount] : settings) value(pose, control) = amount;
  return pose;
}

inline PosedHead posed(const Pose& pose) {
  PosedHead result;
  the_head().pose(pose, result);
  return result;
}

}  // namespace bimodal::synth
