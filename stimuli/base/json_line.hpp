#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace bimodal {

/// The line, from 1, on which a byte of a text stands; an offset beyond the end gives the last
/// line.
[[nodiscard]] std::size_t line_of_offset(std::string_view text, std::size_t offset);

/// The line, from 1, on which the value that an RFC 6901 pointer names begins in a JSON text. The
/// text is expected to be well formed; absent if it has no such value. Of a key that occurs twice
/// the last counts, as for the parser.
[[nodiscard]] std::optional<std::size_t> line_of_pointer(std::string_view text,
                                                         std::string_view pointer);

}  // namespace bimodal
