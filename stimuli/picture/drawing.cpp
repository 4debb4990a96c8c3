#include "stimuli/picture/drawing.hpp"

#include <algorithm>

#include "stimuli/picture/letters.hpp"

namespace bimodal {

namespace {

constexpr std::size_t kBytesPerPixel = 4;

/// The part of a rectangle that is within the picture.
struct Clipped {
  std::size_t left = 0;
  std::size_t right = 0;  ///< one beyond
  std::size_t top = 0;
  std::size_t bottom = 0;
};

Clipped clipped(const Image& image, Place corner, Extent extent) {
  const auto within = [](std::int64_t at, std::size_t size) {
    return static_cast<std::size_t>(
        std::clamp<std::int64_t>(at, 0, static_cast<std::int64_t>(size)));
  };
  return {within(corner.x, image.width),
          within(corner.x + extent.width, image.width),
          within(corner.y, image.height),
          within(corner.y + extent.height, image.height)};
}

bool continues_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

}  // namespace

Image blank_image(std::size_t width, std::size_t height, Colour colour) {
  Image image{width, height, std::vector<std::uint8_t>(width * height * kBytesPerPixel, 255)};
  fill(image, {}, {static_cast<std::int64_t>(width), static_cast<std::int64_t>(height)}, colour);
  return image;
}

void fill(Image& image, Place corner, Extent extent, Colour colour) {
  const auto area = clipped(image, corner, extent);
  for (std::size_t y = area.top; y < area.bottom; ++y) {
    for (std::size_t x = area.left; x < area.right; ++x) {
      auto* const pixel = &image.pixels[(y * image.width + x) * kBytesPerPixel];
      std::ranges::copy(colour, pixel);
    }
  }
}

void paste(Image& image, Place corner, const Image& part) {
  const auto area =
      clipped(image,
              corner,
              {static_cast<std::int64_t>(part.width), static_cast<std::int64_t>(part.height)});
  for (std::size_t y = area.top; y < area.bottom; ++y) {
    const auto row = static_cast<std::size_t>(static_cast<std::int64_t>(y) - corner.y);
    const auto column = static_cast<std::size_t>(static_cast<std::int64_t>(area.left) - corner.x);
    const auto from = part.pixels.begin() +
                      static_cast<std::ptrdiff_t>((row * part.width + column) * kBytesPerPixel);
    std::copy_n(from,
                (area.right - area.left) * kBytesPerPixel,
                image.pixels.begin() +
                    static_cast<std::ptrdiff_t>((y * image.width + area.left) * kBytesPerPixel));
  }
}

void draw_text(
    Image& image, Place corner, std::string_view text, Colour colour, std::int64_t scale) {
  for (const char letter : text) {
    if (continues_character(letter)) continue;
    const auto& rows = letter_rows(letter);
    for (std::size_t y = 0; y < rows.size(); ++y) {
      for (std::size_t x = 0; x < rows.at(y).size(); ++x) {
        if (rows.at(y)[x] != '#') continue;
        fill(image,
             {corner.x + static_cast<std::int64_t>(x) * scale,
              corner.y + static_cast<std::int64_t>(y) * scale},
             {scale, scale},
             colour);
      }
    }
    corner.x += kLetter.width * scale;
  }
}

std::int64_t text_width(std::string_view text, std::int64_t scale) {
  const auto letters =
      std::ranges::count_if(text, [](char letter) { return !continues_character(letter); });
  return letters * kLetter.width * scale;
}

}  // namespace bimodal
