#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "synth/render/head_part.hpp"
#include "synth/render/materials.hpp"
#include "synth/render/quality.hpp"

namespace bimodal::synth {

/// A plane in the room; millimetres, in the coordinates that the head has while it looks ahead.
struct Plane {
  glm::dvec3 normal{1.0, 0.0, 0.0};  ///< any length but 0
  double distance_mm = 0.0;          ///< from the origin, along the normal
};

/// Faces of nothing but points of light (Rosenblum, Johnson & Saldana, 1996).
enum class Points : std::uint8_t {
  None,
  Sparse,  ///< 28 on lips, teeth, tongue, chin, cheeks, nose and brows
  Lips,    ///< at every second vertex or so of the vermilion
  All,     ///< at all vertices of what is shown
};

/// What of the head is drawn, and how.
struct Appearance {
  Materials materials;
  /// Brows and hair are painted on the skin: hidden, they leave it bare.
  PartSet shown = all_parts();
  /// 0 opaque .. 1 invisible: of all that is skin, lips and the mouth's walls among it. Teeth, gums
  /// and tongue are then seen behind it, lit as if it were not there; eyes only between the lids.
  double skin_transparency = 0.0;
  /// What lies on the side to which the normal points is taken away; what the plane cuts is closed
  /// by a face of its own colour.
  std::optional<Plane> cut;
  std::optional<Shading> shading;  ///< absent: as the materials say
  Points points = Points::None;
  Quality quality = Quality::Fast;
  /// 4 samples a pixel, for pictures that need not be drawn while they are shown: with software
  /// OpenGL they cost more than all the rest. 1: edges are smoothed in the finished picture.
  int samples = 1;
};

}  // namespace bimodal::synth
