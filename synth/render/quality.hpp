#pragma once

#include <cstdint>

namespace bimodal::synth {

/// Fast: what light the head casts on itself is worked out once, at rest; edges are smoothed in the
/// picture; a coarser mesh where that is not seen. For interaction and for long sessions.
/// Full: the key light's shadow follows every movement; four samples a pixel; the whole mesh.
enum class Quality : std::uint8_t { Fast, Full };

}  // namespace bimodal::synth
