#pragma once

#include <array>
#include <string_view>

namespace bimodal {

/// The seven rows of a letter, from the top, each of five columns; "#" is ink.
using LetterRows = std::array<std::string_view, 7>;

/// Letters, digits and the common marks of ASCII, drawn by us; a box for what we have not drawn.
[[nodiscard]] const LetterRows& letter_rows(char letter);

}  // namespace bimodal
