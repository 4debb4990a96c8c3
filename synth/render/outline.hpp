#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace bimodal::synth {

/// Points in a plane, in the order of the line through them; the inside is on one hand always.
struct Outline {
  std::vector<glm::vec3> points;
  bool is_closed = false;  ///< the last point is joined to the first
};

/// The lines in which the surface of `triangles` (three vertices each, all turned alike) meets the
/// plane of unit `normal`, `distance` mm from the origin along it. Open ones first.
[[nodiscard]] std::vector<Outline> outlines_in(std::span<const glm::vec3> positions,
                                               std::span<const std::uint32_t> triangles,
                                               const glm::vec3& normal,
                                               float distance);

/// What the outlines of one surface enclose, each as the corners of a polygon. Where the surface
/// has holes (the lower end of the neck, the eyes), the end of an open line is joined straight to
/// the nearest beginning of one.
[[nodiscard]] std::vector<std::vector<glm::vec3>> polygons_of(std::vector<Outline> outlines);

}  // namespace bimodal::synth
