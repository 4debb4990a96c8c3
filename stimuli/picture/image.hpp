#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace bimodal {

/// A picture: rows from the top, 4 bytes a pixel (red, green, blue, opaque), sRGB.
struct Image {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> pixels;
};

/// How hard a PNG is packed.
enum class Packing {
  Small,
  Fast,  ///< in a fifth of the time, a third larger: for long series
};

/// Overwrites `file`, which is never half there. Throws Error, naming it, if it cannot be written
/// or does not end with ".png".
void write_png(const Image& image,
               const std::filesystem::path& file,
               Packing packing = Packing::Small);

/// Any PNG without transparency, converted to 8-bit sRGB. Throws Error, naming `file`, if it is
/// missing, damaged, larger than 16384 x 16384 pixels, or partly transparent.
[[nodiscard]] Image read_png(const std::filesystem::path& file);

}  // namespace bimodal
