#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace bimodal::synth {

/// x, y, z and a zero: what a register of the processor holds, so that every operation works on all
/// coordinates at once. (A vector type of GCC and Clang.)
using Padded = float __attribute__((vector_size(16)));

/// Points or vectors as posing works on them.
using PaddedPoints = std::vector<Padded>;

[[nodiscard]] inline Padded padded(const glm::vec3& point) {
  return Padded{point.x, point.y, point.z, 0.0F};
}

[[nodiscard]] inline Padded padded(const glm::dvec3& point) {
  return padded(glm::vec3{point});
}

[[nodiscard]] inline glm::vec3 unpadded(Padded point) {
  return {point[0], point[1], point[2]};
}

[[nodiscard]] inline Padded cross(Padded a, Padded b) {
  const auto rotated = [](Padded v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3); };
  return rotated(a * rotated(b) - rotated(a) * b);
}

[[nodiscard]] inline float dot(Padded a, Padded b) {
  const Padded product = a * b;
  return product[0] + product[1] + product[2];
}

}  // namespace bimodal::synth
