#include "synth/render/head_renderer.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/asset.hpp"
#include "tests/synth/render/drawn_head.hpp"

namespace bimodal::synth {
namespace {

using enum Control;

constexpr Colour kGreen{0, 255, 0};

View small_view() {
  View view;
  view.width = 320;
  view.height = 360;
  view.backdrop = {kGreen, kGreen};
  return view;
}

Pose open_mouth() {
  return pose_of({{Jaw, 10.0}, {LipWidth, 4.0}, {UpperLipRaise, 2.0}});
}

Pose closed_lips() {
  return pose_of({{Jaw, 2.0}, {LipClosure, 1.0}, {LipCompression, 0.5}});
}

class DrawnHead : public Drawing {
 protected:
  [[nodiscard]] Image drawn(const Pose& pose, const View& view = small_view()) const {
    Image image;
    HeadRenderer{head_, view}.draw(pose, image);
    return image;
  }

  Head head_{asset("synth/assets/head")};
};

std::array<int, 3> pixel(const Image& image, std::size_t x, std::size_t y) {
  const std::size_t i = 4 * (y * image.width + x);
  return {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]};
}

bool is_backdrop(const Image& image, std::size_t x, std::size_t y) {
  return pixel(image, x, y) == std::array<int, 3>{0, 255, 0};
}

/// Nearly as much green as red: skin has 0.8 of it, lips 0.6.
bool is_tooth(const Image& image, std::size_t x, std::size_t y) {
  const auto [red, green, blue] = pixel(image, x, y);
  return red > 110 && green * 100 > red * 91 && blue * 100 > red * 75;
}

template <typename Property>
int count_pixels(const Image& image, Property property) {
  int count = 0;
  for (std::size_t y = 0; y < image.height; ++y) {
    for (std::size_t x = 0; x < image.width; ++x) count += property(image, x, y) ? 1 : 0;
  }
  return count;
}

/// The part of the picture round the mouth, from the nose to the chin.
Image mouth_part(const Image& image) {
  const std::size_t left = image.width / 3;
  const std::size_t top = image.height * 62 / 100;
  Image part{image.width / 3, image.height / 4, {}};
  for (std::size_t y = 0; y < part.height; ++y) {
    const auto* row = &image.pixels[4 * ((top + y) * image.width + left)];
    part.pixels.insert(part.pixels.end(), row, row + 4 * part.width);
  }
  return part;
}

TEST_F(DrawnHead, StandsInTheMiddleBeforeTheBackdrop) {
  const Image image = drawn(neutral_pose());
  ASSERT_EQ(image.width, 320U);
  ASSERT_EQ(image.height, 360U);
  ASSERT_EQ(image.pixels.size(), 320U * 360U * 4U);
  EXPECT_TRUE(is_backdrop(image, 2, 2));
  EXPECT_TRUE(is_backdrop(image, 317, 2));
  const auto [red, green, blue] = pixel(image, 160, 80);  // forehead
  EXPECT_GT(red, green);
  EXPECT_GT(green, blue);
  const int backdrop = count_pixels(image, is_backdrop);
  EXPECT_GT(backdrop, 320 * 360 / 5);
  EXPECT_LT(backdrop, 320 * 360 * 3 / 5);
}

TEST_F(DrawnHead, IsOpaqueEverywhere) {
  const Image image = drawn(open_mouth());
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) ASSERT_EQ(image.pixels[i], 255);
}

TEST_F(DrawnHead, HasAnOutlineThatIsTheSameLeftAndRight) {
  const Image image = drawn(neutral_pose());
  const int different = count_pixels(image, [](const Image& it, std::size_t x, std::size_t y) {
    return is_backdrop(it, x, y) != is_backdrop(it, it.width - 1 - x, y);
  });
  EXPECT_LT(different, 320 * 360 / 200);
}

TEST_F(DrawnHead, IsTheSameBytesForTheSamePose) {
  HeadRenderer first{head_, small_view()};
  Image before;
  first.draw(open_mouth(), before);
  Image other;
  first.draw(closed_lips(), other);
  Image after;
  first.draw(open_mouth(), after);
  EXPECT_EQ(before.pixels, after.pixels);
  EXPECT_NE(before.pixels, other.pixels);
  EXPECT_EQ(drawn(open_mouth()).pixels, before.pixels) << "another renderer draws something else";
}

TEST_F(DrawnHead, KeepsItsUpperFaceStillWhenTheMouthOpens) {
  const Image closed = drawn(neutral_pose());
  const Image open = drawn(open_mouth());
  const auto third = static_cast<std::ptrdiff_t>(closed.pixels.size() / 3);
  EXPECT_TRUE(
      std::equal(closed.pixels.begin(), closed.pixels.begin() + third, open.pixels.begin()));
  EXPECT_NE(mouth_part(closed).pixels, mouth_part(open).pixels);
}

TEST_F(DrawnHead, ShowsTeethOnlyBetweenOpenLips) {
  const int open = count_pixels(mouth_part(drawn(open_mouth())), is_tooth);
  const int closed = count_pixels(mouth_part(drawn(closed_lips())), is_tooth);
  EXPECT_GT(open, 60);
  EXPECT_LT(closed, 5);
}

TEST_F(DrawnHead, ShowsTheTonguesTipBetweenTheTeeth) {
  const Pose without = pose_of({{Jaw, 5.0}, {UpperLipRaise, 1.0}, {LowerLipRaise, -1.0}});
  Pose with = without;
  value(with, TongueLength) = 15.0;
  value(with, TongueAngle) = 8.0;
  value(with, TongueThickness) = 0.8;
  const Image image_with = drawn(with);
  const Image image_without = drawn(without);
  const auto differs = [&](const Image& image, std::size_t x, std::size_t y) {
    return std::abs(pixel(image, x, y)[0] - pixel(image_without, x, y)[0]) > 20;
  };
  const auto differs_beside_the_mouth = [&](const Image& image, std::size_t x, std::size_t y) {
    const bool beside = x < 110 || x > 210 || y < 220 || y > 290;
    return beside && pixel(image, x, y) != pixel(image_without, x, y);
  };
  EXPECT_GT(count_pixels(image_with, differs), 100);
  EXPECT_EQ(count_pixels(image_with, differs_beside_the_mouth), 0);
}

TEST_F(DrawnHead, TurnedByTheCameraShowsItsLeftEar) {
  View view = small_view();
  view.yaw_deg = 60.0;
  const Image image = drawn(neutral_pose(), view);
  // Seen from its left the face looks to the picture's left: the brow is there, hair on the right.
  const auto brightness = [&image](std::size_t x) {
    const auto [red, green, blue] = pixel(image, x, 80);
    return red + green + blue;
  };
  EXPECT_GT(brightness(110), brightness(230) + 150);
}

TEST_F(DrawnHead, MayBeDrawnInTwoThreadsAtOnce) {
  std::array<Image, 2> images;
  const auto work = [this](Image& image) {
    HeadRenderer renderer{head_, small_view()};
    for (int i = 0; i < 3; ++i) renderer.draw(open_mouth(), image);
  };
  std::thread first{work, std::ref(images[0])};
  std::thread second{work, std::ref(images[1])};
  first.join();
  second.join();
  EXPECT_EQ(images[0].pixels, images[1].pixels);
}

TEST_F(DrawnHead, SaysWhatDrawsIt) {
  EXPECT_THAT((HeadRenderer{head_, small_view()}.description()), testing::HasSubstr("OpenGL"));
}

}  // namespace
}  // namespace bimodal::synth
