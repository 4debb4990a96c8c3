#pragma once

#include <string>
#include <string_view>

namespace bimodal {

/// The text of a label file as UTF-8 without byte order mark, every line ending in '\n' alone.
///
/// With a byte order mark the bytes are UTF-8 or UTF-16 of either order; without, UTF-8 if they are
/// well formed in it, otherwise Latin-1 (ISO 8859-1), in which everything is. Throws Error, naming
/// the file and the line, if UTF-16 is broken or a character is NUL, which text has not.
[[nodiscard]] std::string decode_text(std::string_view bytes, std::string_view file);

}  // namespace bimodal
