#pragma once

#include <array>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "synth/render/egl_context.hpp"
#include "synth/render/head_renderer.hpp"
#include "tests/synth/face/the_head.hpp"

namespace bimodal::synth {

/// For tests that draw; they are skipped where there is no OpenGL.
class Drawing : public testing::Test {
 protected:
  void SetUp() override {
    try {
      const EglContext probe;
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
  }

  [[nodiscard]] static Image drawn(const Pose& pose,
                                   const View& view,
                                   const Appearance& appearance) {
    Image image;
    HeadRenderer{the_head(), view, appearance}.draw(pose, image);
    return image;
  }
};

/// Red, green, blue.
inline std::array<int, 3> pixel(const Image& image, std::size_t i) {
  return {image.pixels[4 * i], image.pixels[4 * i + 1], image.pixels[4 * i + 2]};
}

/// How many pixels are within 3 of 255 of a colour.
inline int count_of(const Image& image, const Colour& colour) {
  int count = 0;
  for (std::size_t i = 0; i < image.width * image.height; ++i) {
    const auto it = pixel(image, i);
    const auto is_near = [&](std::size_t c) { return std::abs(it.at(c) - colour.at(c)) <= 3; };
    count += is_near(0) && is_near(1) && is_near(2) ? 1 : 0;
  }
  return count;
}

/// How many pixels of two pictures differ by more than `most` in some colour.
inline int count_differing(const Image& one, const Image& other, int most = 0) {
  int count = 0;
  for (std::size_t i = 0; i < one.width * one.height; ++i) {
    const auto a = pixel(one, i);
    const auto b = pixel(other, i);
    const auto differs = [&](std::size_t c) { return std::abs(a.at(c) - b.at(c)) > most; };
    count += differs(0) || differs(1) || differs(2) ? 1 : 0;
  }
  return count;
}

}  // namespace bimodal::synth
