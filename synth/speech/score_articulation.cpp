#include "synth/speech/score_articulation.hpp"

namespace bimodal::synth {

ScoreArticulation::ScoreArticulation(const ScoreClaims& claims, Account account)
    : movement_{claims.movement(account)}, values_(claims.controls.size()) {
  controls_.reserve(claims.controls.size());
  for (const auto& name : claims.controls) controls_.push_back(control_from_name(name));
}

Pose ScoreArticulation::at(Milliseconds time) {
  movement_->at(time, values_);
  auto pose = neutral_pose();
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (controls_[i]) value(pose, *controls_[i]) = values_[i];
  }
  return pose;
}

}  // namespace bimodal::synth
