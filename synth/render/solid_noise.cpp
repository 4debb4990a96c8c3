#include "synth/render/solid_noise.hpp"

#include <cmath>
#include <cstdint>

#include <glm/common.hpp>

namespace bimodal::synth {

namespace {

/// 0..1 for a corner of the unit lattice.
float lattice_value(std::int32_t x, std::int32_t y, std::int32_t z) {
  std::uint32_t hash = static_cast<std::uint32_t>(x) * 374761393U +
                       static_cast<std::uint32_t>(y) * 668265263U +
                       static_cast<std::uint32_t>(z) * 2246822519U;
  hash = (hash ^ (hash >> 13U)) * 1274126177U;
  hash ^= hash >> 16U;
  return static_cast<float>(hash & 0xffffffU) / static_cast<float>(0xffffffU);
}

}  // namespace

float solid_noise(glm::vec3 position) {
  const glm::vec3 corner = glm::floor(position);
  glm::vec3 t = position - corner;
  t = t * t * (3.0F - 2.0F * t);
  const auto x = static_cast<std::int32_t>(corner.x);
  const auto y = static_cast<std::int32_t>(corner.y);
  const auto z = static_cast<std::int32_t>(corner.z);
  const auto along_x = [&](std::int32_t dy, std::int32_t dz) {
    return glm::mix(lattice_value(x, y + dy, z + dz), lattice_value(x + 1, y + dy, z + dz), t.x);
  };
  const auto along_y = [&](std::int32_t dz) {
    return glm::mix(along_x(0, dz), along_x(1, dz), t.y);
  };
  return glm::mix(along_y(0), along_y(1), t.z);
}

float cloudy_noise(glm::vec3 position) {
  constexpr int kOctaves = 3;
  constexpr float kFiner = 2.03F;  // not 2, so that the lattices of the octaves never coincide
  float sum = 0.0F;
  float weight = 0.5F;
  for (int octave = 0; octave < kOctaves; ++octave) {
    sum += weight * solid_noise(position);
    position *= kFiner;
    weight *= 0.5F;
  }
  return sum;
}

}  // namespace bimodal::synth
