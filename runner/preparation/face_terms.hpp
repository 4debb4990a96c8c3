#pragma once

#include "protocols/model/face_terms.hpp"

namespace bimodal::runner {

/// What the face that ships can be asked for in a protocol: the views, points of light, materials,
/// parts and expressions that the command line knows too, and every control that speech leaves
/// alone.
[[nodiscard]] protocols::FaceTerms face_terms();

}  // namespace bimodal::runner
