#pragma once

#include <vector>

#include "synth/face/obj_reader.hpp"
#include "synth/face/rigid_part.hpp"

namespace bimodal::synth {

/// The surfaces of one eye, from its cage in the head's OBJ: the ball and a separate cornea bulging
/// before the iris, which turn with the gaze; a flattened white and the caruncle, which close the
/// gaps at the corners and do not turn.
///
/// Their rest positions tell the material where it is on the eye. Ball and cornea: the unit vector
/// from the centre (gaze +z). White: (nasal to temporal, up, -9). Caruncle: within 0.2 of (0, 0,
/// -1).
[[nodiscard]] std::vector<RigidPart> eye_parts(const Cage& cage, bool left);

/// Turns an eye by the gaze, degrees; positive to the subject's left and down.
[[nodiscard]] RigidMotion gaze(bool left, double x_deg, double y_deg);

}  // namespace bimodal::synth
