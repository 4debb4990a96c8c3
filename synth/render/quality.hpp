#pragma once

#include <cstdint>

namespace bimodal::synth {

/// Fast: what light the head keeps from itself is worked out once, at rest; a coarser mesh where
/// that is not seen. For interaction and for long sessions. Full: the key light's shadow follows
/// every movement (teeth under the lip, nose, chin); its light is worked out for each pixel; a
/// finer mesh.
enum class Quality : std::uint8_t { Fast, Full };

}  // namespace bimodal::synth
