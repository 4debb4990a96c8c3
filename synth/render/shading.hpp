#pragma once

#include <cstdint>

namespace bimodal::synth {

/// Where light is worked out: for every pixel; for the vertices, and between them mixed (Gouraud,
/// 1971, as in Cohen & Massaro, 1993); or once for each triangle.
enum class Shading : std::uint8_t { Smooth, Gouraud, Flat };

}  // namespace bimodal::synth
