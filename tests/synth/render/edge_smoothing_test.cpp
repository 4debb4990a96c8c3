#include "synth/render/edge_smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

namespace bimodal::synth {
namespace {

constexpr std::size_t kSize = 64;

/// Grey picture of value(x, y).
template <typename Value>
Image grey(Value value) {
  Image image{kSize, kSize, std::vector<std::uint8_t>(kSize * kSize * 4, 255)};
  for (std::size_t y = 0; y < kSize; ++y) {
    for (std::size_t x = 0; x < kSize; ++x) {
      std::fill_n(&image.pixels[4 * (y * kSize + x)], 3, value(x, y));
    }
  }
  return image;
}

Image smoothed(const Image& image) {
  EdgeSmoothing smoothing;
  Image result;
  smoothing.apply(image, result);
  return result;
}

/// How much of a pixel lies below the line y = 20 + x * slope: 255 for all of it.
std::uint8_t covered(std::size_t x, std::size_t y, double slope) {
  constexpr int kSteps = 64;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double line = 20.0 + (static_cast<double>(x) + (i + 0.5) / kSteps) * slope;
    sum += std::clamp(static_cast<double>(y) + 1.0 - line, 0.0, 1.0);
  }
  return static_cast<std::uint8_t>(std::lround(255.0 * sum / kSteps));
}

double mean_difference(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(a.pixels[i] - b.pixels[i]);
  return sum / static_cast<double>(a.pixels.size());
}

TEST(EdgeSmoothing, LeavesAnEvenPictureAsItIs) {
  const Image even = grey([](std::size_t, std::size_t) { return std::uint8_t{77}; });
  EXPECT_EQ(smoothed(even).pixels, even.pixels);
}

TEST(EdgeSmoothing, LeavesSlowShadingAsItIs) {
  const Image ramp =
      grey([](std::size_t x, std::size_t y) { return static_cast<std::uint8_t>(60 + x + y); });
  EXPECT_EQ(smoothed(ramp).pixels, ramp.pixels);
}

TEST(EdgeSmoothing, BringsAStaircaseNearerToTheTrueLine) {
  for (const double slope : {0.1, 0.25, 0.4, 0.6}) {
    const Image truth = grey([&](std::size_t x, std::size_t y) { return covered(x, y, slope); });
    const Image staircase = grey([&](std::size_t x, std::size_t y) {
      return static_cast<std::uint8_t>(covered(x, y, slope) >= 128 ? 255 : 0);
    });
    EXPECT_LT(mean_difference(smoothed(staircase), truth), 0.6 * mean_difference(staircase, truth))
        << "slope " << slope;
  }
}

TEST(EdgeSmoothing, KeepsEveryPixelOpaque) {
  const Image chequered = grey([](std::size_t x, std::size_t y) {
    return static_cast<std::uint8_t>((x / 3 + y / 5) % 2 == 0 ? 20 : 230);
  });
  const Image result = smoothed(chequered);
  for (std::size_t i = 3; i < result.pixels.size(); i += 4) ASSERT_EQ(result.pixels[i], 255);
}

}  // namespace
}  // namespace bimodal::synth
