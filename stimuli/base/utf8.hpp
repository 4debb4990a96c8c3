#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace bimodal {

/// Length in bytes of the well-formed UTF-8 character that begins at byte `at` of the text, which
/// has one (Unicode 15, table 3-7); 0 if there is none.
[[nodiscard]] std::size_t utf8_length(std::string_view text, std::size_t at);

/// Whether the whole text is well-formed UTF-8.
[[nodiscard]] bool is_utf8(std::string_view text);

/// Appends a code point up to U+10FFFF that is no surrogate.
void append_utf8(std::string& text, char32_t character);

}  // namespace bimodal
