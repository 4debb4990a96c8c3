#pragma once

#include <string>

namespace bimodal::synth {

/// GL_RENDERER and GL_VERSION of the OpenGL that draws the head off-screen, without making a
/// renderer. Throws Error if OpenGL cannot be had, as HeadRenderer does.
[[nodiscard]] std::string opengl_description();

}  // namespace bimodal::synth
