#include "stimuli/picture/resize.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace bimodal {
namespace {

Image grey(std::size_t width, std::size_t height, auto value) {
  Image image{.width = width, .height = height, .pixels = {}};
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const auto level = static_cast<std::uint8_t>(value(x, y));
      image.pixels.insert(image.pixels.end(), {level, level, level, 255});
    }
  }
  return image;
}

double at(const Image& image, std::size_t x, std::size_t y) {
  return static_cast<double>(image.pixels[(y * image.width + x) * 4]);
}

TEST(Resize, KeepsAPlainPicturePlainAtEverySize) {
  const auto plain = grey(37, 23, [](auto, auto) { return 141; });
  for (const auto& [width, height] : {std::pair{5U, 90U}, {100U, 3U}, {1U, 1U}, {74U, 46U}}) {
    const auto image = resized(plain, width, height);
    ASSERT_EQ(image.pixels.size(), width * height * 4U);
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
      EXPECT_EQ(image.pixels[i], 141);
      EXPECT_EQ(image.pixels[i + 3], 255);
    }
  }
}

TEST(Resize, AtItsOwnSizeIsTheVeryPicture) {
  const auto image = grey(9, 7, [](auto x, auto y) { return 20 * x + y; });
  EXPECT_EQ(resized(image, 9, 7).pixels, image.pixels);
}

// Catmull-Rom reproduces straight lines: with pixel centres at half-integers, pixel i of twice the
// size lies at (i + 1/2) / 2 - 1/2.
TEST(Resize, PutsARampWhereItBelongs) {
  const auto ramp = grey(40, 4, [](auto x, auto) { return 5 * x; });
  const auto twice = resized(ramp, 80, 4);
  for (std::size_t x = 8; x < 72; ++x) {
    EXPECT_NEAR(at(twice, x, 2), 5.0 * ((static_cast<double>(x) + 0.5) / 2.0 - 0.5), 0.51);
  }
  const auto half = resized(ramp, 20, 4);
  for (std::size_t x = 4; x < 16; ++x) {
    EXPECT_NEAR(at(half, x, 1), 5.0 * (2.0 * static_cast<double>(x) + 0.5), 0.51);
  }
}

TEST(Resize, ShrinkingDoesNotAlias) {
  const auto stripes = grey(64, 8, [](auto x, auto) { return x % 2 == 0 ? 0 : 200; });
  const auto small = resized(stripes, 16, 8);
  for (std::size_t x = 3; x < 13; ++x) EXPECT_NEAR(at(small, x, 4), 100.0, 4.0);
}

TEST(Blur, SpreadsAnEdgeAsTheNormalDistribution) {
  const auto edge = grey(60, 40, [](auto x, auto) { return x < 30 ? 0 : 255; });
  const auto soft = blurred(edge, 3.0);
  for (std::size_t x = 20; x < 40; ++x) {
    const double z = (static_cast<double>(x) + 0.5 - 30.0) / 3.0;
    EXPECT_NEAR(at(soft, x, 20), 255.0 * 0.5 * std::erfc(-z / std::sqrt(2.0)), 2.5) << x;
  }
  EXPECT_EQ(blurred(edge, 0.0).pixels, edge.pixels);
}

}  // namespace
}  // namespace bimodal
