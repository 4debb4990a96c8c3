#pragma once

#include <cstddef>

#include "stimuli/picture/image.hpp"

namespace bimodal {

/// The picture at another size: separable Catmull-Rom interpolation (B = 0, C = 1/2 of Mitchell &
/// Netravali, 1988), widened where the picture shrinks so that nothing aliases; beyond the edges
/// the outermost pixels go on. Done on the stored (sRGB) values, as video equipment does. At its
/// own size the very picture. Both sizes at least 1.
[[nodiscard]] Image resized(const Image& image, std::size_t width, std::size_t height);

/// Gaussian blur of a standard deviation in pixels, cut off at three of them; 0: the very picture.
[[nodiscard]] Image blurred(const Image& image, double deviation_px);

}  // namespace bimodal
