#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "stimuli/picture/image.hpp"

namespace bimodal {

/// Red, green, blue, sRGB.
using Colour = std::array<std::uint8_t, 3>;

/// Columns from the left and rows from the top; what lies outside a picture is not drawn.
struct Place {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

struct Extent {
  std::int64_t width = 0;
  std::int64_t height = 0;
};

/// A picture of one colour.
[[nodiscard]] Image blank_image(std::size_t width, std::size_t height, Colour colour);

/// Fills a rectangle.
void fill(Image& image, Place corner, Extent extent, Colour colour);

/// Copies a whole picture into another one.
void paste(Image& image, Place corner, const Image& part);

/// Size of a letter of draw_text with the blank column and row after it, at scale 1.
inline constexpr Extent kLetter{6, 8};

/// Writes one line in letters of 5 x 7 pixels of our own, each `scale` times as large, its upper
/// left corner at `corner`. ASCII; any other character is drawn as a box.
void draw_text(
    Image& image, Place corner, std::string_view text, Colour colour, std::int64_t scale = 1);

/// How wide a line is. A character of several bytes (UTF-8) counts once.
[[nodiscard]] std::int64_t text_width(std::string_view text, std::int64_t scale = 1);

}  // namespace bimodal
