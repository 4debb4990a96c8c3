#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace bimodal {

/// Text as it stands in HTML and SVG, in elements and attributes alike.
[[nodiscard]] std::string escaped(std::string_view text);

/// RFC 4648, with padding.
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace bimodal
