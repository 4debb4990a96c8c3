#pragma once

#include <vector>

#include "synth/face/obj_reader.hpp"
#include "synth/face/rigid_part.hpp"

namespace bimodal::synth {

/// The surfaces of one eye, from its cage in the head's OBJ: the ball, whose iris stands out, and a
/// separate cornea bulging before it turn with the gaze; all white between the lids, with the
/// caruncle in its inner corner, is one surface that does not turn, so that it has no join at the
/// corners and keeps its light.
///
/// Their rest positions tell the material where it is on the eye. Ball and cornea: the unit vector
/// from the centre (gaze +z). White: (nasal to temporal, up) from the centre, in radii, and -9.
[[nodiscard]] std::vector<RigidPart> eye_parts(const Cage& cage, bool left);

/// Turns an eye by the gaze, degrees; positive to the subject's left and down.
[[nodiscard]] RigidMotion gaze(bool left, double x_deg, double y_deg);

}  // namespace bimodal::synth
