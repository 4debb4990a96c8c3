#pragma once

#include <glm/vec3.hpp>

namespace bimodal::synth {

/// Value noise of period 1 in space, 0..1, smooth, the same on every machine; solid texture for
/// what does not need a pixel's resolution. The shaders have the same function (noise.glsl).
[[nodiscard]] float solid_noise(glm::vec3 position);

/// Three octaves of it, each of half the size and half the weight; mean 0.44.
[[nodiscard]] float cloudy_noise(glm::vec3 position);

}  // namespace bimodal::synth
