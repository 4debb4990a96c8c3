#include "synth/face/jaw_followers.hpp"

#include <algorithm>

namespace bimodal::synth {

JawFollowers::JawFollowers(std::span<const double> weights) {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] != 0.0) followers_.push_back({.vertex = i, .weight = weights[i]});
  }
  std::ranges::stable_sort(followers_, {}, &Follower::weight);
}

void JawFollowers::move(const JawMotion& jaw, std::span<glm::dvec3> skin) const {
  RigidMotion motion;
  double moved_by = 0.0;
  for (const auto& [vertex, weight] : followers_) {
    if (weight != moved_by) {
      motion = jaw.rigid(weight);
      moved_by = weight;
    }
    skin[vertex] = motion.move(skin[vertex]);
  }
}

}  // namespace bimodal::synth
