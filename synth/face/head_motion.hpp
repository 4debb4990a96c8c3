#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "synth/face/padded.hpp"
#include "synth/face/rigid_motion.hpp"
#include "synth/face/surface.hpp"
#include "synth/speech/control.hpp"

namespace bimodal::synth {

/// Yaw, pitch and roll of the head about the atlas.
[[nodiscard]] RigidMotion head_motion(const Pose& pose);

/// Turns the drawn skin; `follow` is 1 on the head and falls to 0 down the neck.
void turn_skin(const RigidMotion& head, std::span<const float> follow, std::span<Padded> positions);

/// Turns all of a surface.
void turn(const RigidMotion& head, SurfaceGeometry& surface);

}  // namespace bimodal::synth
