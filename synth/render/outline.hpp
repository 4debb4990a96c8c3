#pragma once

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

}  // namespace bimodal::synth
