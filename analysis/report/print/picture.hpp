#pragma once

#include <string>
#include <string_view>

namespace bimodal::analysis {

/// An SVG document of a picture's size that shows the picture, given as it stands in a page
/// ("data:image/png;base64,..."). Throws Error if it is no picture.
[[nodiscard]] std::string drawing_of_picture(std::string_view source);

}  // namespace bimodal::analysis
