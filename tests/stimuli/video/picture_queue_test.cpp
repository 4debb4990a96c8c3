#include "stimuli/video/picture_queue.hpp"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace bimodal {
namespace {

Image picture(std::uint8_t level) {
  return {.width = 1, .height = 1, .pixels = {level, level, level, 255}};
}

TEST(PictureQueue, DoesTheWorkInOrder) {
  std::vector<int> done;
  PictureQueue queue{[&done](const Image& image) { done.push_back(image.pixels[0]); }};
  Image reused;
  for (int i = 0; i < 100; ++i) {
    reused = picture(static_cast<std::uint8_t>(i));
    queue.add(reused);
  }
  queue.finish();
  ASSERT_EQ(done.size(), 100);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
}

TEST(PictureQueue, PassesOnWhatTheWorkThrows) {
  int done = 0;
  PictureQueue queue{[&done](const Image&) {
    if (++done == 3) throw std::runtime_error{"the disk is full"};
  }};
  EXPECT_THROW(
      {
        for (int i = 0; i < 100; ++i) queue.add(picture(0));
      },
      std::runtime_error);
  EXPECT_THROW(queue.finish(), std::runtime_error);
  EXPECT_EQ(done, 3);
}

TEST(PictureQueue, EndsWithoutBeingFinished) {
  std::vector<int> done;
  {
    PictureQueue queue{[&done](const Image& image) { done.push_back(image.pixels[0]); }};
    queue.add(picture(1));
  }
  EXPECT_LE(done.size(), 1U);
}

}  // namespace
}  // namespace bimodal
