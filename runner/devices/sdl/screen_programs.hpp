#pragma once

#include <epoxy/gl.h>

namespace bimodal::runner {

/// Programs for the current OpenGL context whose vertices are places in pixels of the "window"
/// (location 0, from its upper left corner) and in a texture (location 1). Throw DeviceError where
/// the driver refuses them.
[[nodiscard]] GLuint linked_picture_program();

/// Takes an "ink" and draws it where the texture covers.
[[nodiscard]] GLuint linked_ink_program();

/// Bound, without pixels, and drawn pixel by pixel.
[[nodiscard]] GLuint new_texture();

/// Coverage of a smooth disc that fills its texture. Its edge is two texels wide: drawn smaller, it
/// is smooth.
[[nodiscard]] GLuint disc_texture();

}  // namespace bimodal::runner
