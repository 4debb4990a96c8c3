#include "synth/render/view.hpp"

#include <cmath>

#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>

#include "synth/render/camera.hpp"

namespace bimodal::synth {

namespace {

constexpr glm::vec3 kRestingLips{0.0F, -76.0F, 104.0F};  // between them, on the midline

double angle_deg(double size, double distance) {
  return glm::degrees(2.0 * std::atan(0.5 * size / distance));
}

/// From the camera, along its axis.
double depth_of_lips(const View& view) {
  const glm::dvec3 centre{view.centre_x_mm, view.centre_y_mm, view.centre_z_mm};
  return view.distance_mm -
         glm::dot(glm::dvec3{kRestingLips} - centre, glm::dvec3{towards_camera(view)});
}

}  // namespace

std::optional<VisualAngles> angles_at_camera(const View& view) {
  if (view.projection == Projection::Orthographic) return std::nullopt;
  return VisualAngles{.picture_deg = angle_deg(view.field_mm, view.distance_mm),
                      .lip_millimetre_deg = angle_deg(1.0, depth_of_lips(view))};
}

double lips_height(const View& view) {
  const auto place = camera_for(view).clip_from_world * glm::vec4{kRestingLips, 1.0F};
  return 0.5 + 0.5 * static_cast<double>(place.y / place.w);
}

VisualAngles angles_on(const Screen& screen, const View& view) {
  const bool is_parallel = view.projection == Projection::Orthographic;
  const double nearness = is_parallel ? 1.0 : view.distance_mm / depth_of_lips(view);
  const double millimetre = nearness * screen.picture_height_mm / view.field_mm;
  return {.picture_deg = angle_deg(screen.picture_height_mm, screen.viewing_distance_mm),
          .lip_millimetre_deg = angle_deg(millimetre, screen.viewing_distance_mm)};
}

}  // namespace bimodal::synth
