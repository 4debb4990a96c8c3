#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "synth/render/backdrop.hpp"

namespace bimodal::synth {

enum class Projection : std::uint8_t { Perspective, Orthographic };

/// From where the head is seen.
struct View {
  std::size_t width = 640;     ///< pixels
  std::size_t height = 720;    ///< pixels
  double yaw_deg = 0.0;        ///< camera round the head; positive shows the subject's left side
  double pitch_deg = 0.0;      ///< positive looks from above
  double centre_y_mm = -30.0;  ///< what stands in the middle of the picture
  double field_mm = 270.0;     ///< height of the picture at the centre
  std::optional<Backdrop> backdrop;  ///< absent: the materials' own
  double centre_x_mm = 0.0;
  double centre_z_mm = 12.0;  ///< before the ear canals; about the middle of the head
  Projection projection = Projection::Perspective;
  /// Of the camera from the centre. 1.1 m, as across a table: near enough for natural perspective,
  /// far enough that the face is not distorted. At least kNearestCamera.
  double distance_mm = 1100.0;
};

inline constexpr double kNearestCamera = 350.0;  ///< mm; nearer ones would stand in the head

/// How large something is on the retina, in degrees.
struct VisualAngles {
  double picture_deg = 0.0;         ///< the picture's height
  double lip_millimetre_deg = 0.0;  ///< a millimetre at the resting lips, across the line of sight
};

/// For an eye at the camera; absent where lines of sight are parallel.
[[nodiscard]] std::optional<VisualAngles> angles_at_camera(const View& view);

/// Where the resting lips meet: a part of the picture's height, from its top. Beyond 0 to 1: the
/// picture does not show them.
[[nodiscard]] double lips_height(const View& view);

/// How a participant sees the picture.
struct Screen {
  double viewing_distance_mm = 600.0;
  double picture_height_mm = 200.0;  ///< of the shown picture
};

[[nodiscard]] VisualAngles angles_on(const Screen& screen, const View& view);

}  // namespace bimodal::synth
