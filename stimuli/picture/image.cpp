#include "stimuli/picture/image.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include <fmt/format.h>
#include <png.h>

#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/lower_case.hpp"

namespace bimodal {

namespace {

constexpr std::size_t kBytesPerPixel = 4;
/// Larger than any screen; a file that claims more is damaged or not meant for us.
constexpr std::size_t kMostPixels = std::size_t{16384} * 16384;

png_image png_in_our_layout() {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.format = PNG_FORMAT_RGBA;
  return png;
}

/// libpng's own words about what went wrong, freeing what it still holds.
std::string complaint(png_image& png) {
  std::string text = static_cast<const char*>(png.message);
  png_image_free(&png);
  return text;
}

bool is_opaque(const Image& image) {
  for (std::size_t i = 3; i < image.pixels.size(); i += kBytesPerPixel) {
    if (image.pixels[i] != 255) return false;
  }
  return true;
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& file, Packing packing) {
  assert(image.width > 0 && image.height > 0);
  assert(image.pixels.size() == image.width * image.height * kBytesPerPixel);
  if (lower_case(file.extension().string()) != ".png") {
    throw Error{
        fmt::format("'{}': pictures are written as PNG; end the name with .png", file.string())};
  }
  Draft draft{file};
  png_image png = png_in_our_layout();
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  if (packing == Packing::Fast) png.flags |= PNG_IMAGE_FLAG_FAST;
  constexpr int kEightBits = 0;
  constexpr int kRowsFromTheTop = 0;  // the stride that libpng works out itself, positive
  if (png_image_write_to_file(
          &png, draft.path().c_str(), kEightBits, image.pixels.data(), kRowsFromTheTop, nullptr) ==
      0) {
    throw Error{fmt::format("cannot write the picture '{}' ({} x {}): {}",
                            file.string(),
                            image.width,
                            image.height,
                            complaint(png))};
  }
  draft.keep();
}

Image read_png(const std::filesystem::path& file) {
  const auto refuse = [&file](const std::string& finding) {
    return Error{fmt::format("cannot read the picture '{}': {}", file.string(), finding)};
  };
  png_image png = png_in_our_layout();
  if (png_image_begin_read_from_file(&png, file.c_str()) == 0) throw refuse(complaint(png));
  png.format = PNG_FORMAT_RGBA;  // begin_read has put the file's own layout here
  const std::size_t pixels = std::size_t{png.width} * png.height;
  if (pixels > kMostPixels) {
    png_image_free(&png);
    throw refuse(fmt::format("it claims {} x {} pixels; at most {} are read",
                             std::uint32_t{png.width},
                             std::uint32_t{png.height},
                             kMostPixels));
  }
  Image image{png.width, png.height, std::vector<std::uint8_t>(pixels * kBytesPerPixel)};
  if (png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr) == 0) {
    throw refuse(complaint(png));
  }
  if (!is_opaque(image)) throw refuse("it is partly transparent; save it without an alpha channel");
  return image;
}

}  // namespace bimodal
