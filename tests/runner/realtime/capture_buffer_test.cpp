#include "runner/realtime/capture_buffer.hpp"

#include <array>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/runner/realtime/count_allocations.hpp"

namespace bimodal::runner {
namespace {

TEST(CaptureBuffer, TakesTheFirstChannel) {
  CaptureBuffer<8> buffer;
  constexpr std::array<float, 6> kStereo{1, -1, 2, -2, 3, -3};
  buffer.write(kStereo, 2, false);
  EXPECT_EQ(buffer.try_pop(), 1.0F);
  EXPECT_EQ(buffer.try_pop(), 2.0F);
  EXPECT_EQ(buffer.try_pop(), 3.0F);
  EXPECT_FALSE(buffer.try_pop());
  EXPECT_EQ(buffer.lost(), 0);
}

TEST(CaptureBuffer, TakesOrLosesFramesWhole) {
  CaptureBuffer<4> buffer{2};
  constexpr std::array<float, 9> kThree{1, -1, 9, 2, -2, 9, 3, -3, 9};
  buffer.write(kThree, 3, false);
  for (const float expected : {1.0F, -1.0F, 2.0F, -2.0F}) EXPECT_EQ(buffer.try_pop(), expected);
  EXPECT_FALSE(buffer.try_pop());
  EXPECT_EQ(buffer.lost(), 1);
  buffer.write(std::span{kThree}.first(3), 3, false);
  EXPECT_EQ(buffer.try_pop(), 1.0F);
  buffer.write(std::span{kThree}.last(6), 3, false);  // room for one and a half
  EXPECT_EQ(buffer.lost(), 2);
}

TEST(CaptureBuffer, CountsWhatDoesNotFitAndWhatTheDeviceLost) {
  CaptureBuffer<4> buffer;
  constexpr std::array<float, 6> kSamples{1, 2, 3, 4, 5, 6};
  buffer.write(kSamples, 1, false);
  EXPECT_EQ(buffer.lost(), 2);
  for (const float expected : {1.0F, 2.0F, 3.0F, 4.0F}) EXPECT_EQ(buffer.try_pop(), expected);
  buffer.write(std::span{kSamples}.first(1), 1, true);
  EXPECT_EQ(buffer.lost(), 3);
  EXPECT_EQ(buffer.try_pop(), 1.0F);
}

TEST(CaptureBuffer, DoesNotAllocateInTheCallback) {
  const auto buffer = std::make_unique<CaptureBuffer<1024>>();
  const std::vector<float> samples(4096, 0.5F);
  const auto before = allocations_of_this_thread();
  buffer->write(samples, 2, true);
  EXPECT_EQ(allocations_of_this_thread(), before);
  EXPECT_EQ(buffer->lost(), 1024 + 1);
}

TEST(CaptureBuffer, LosesNothingUncountedBetweenTwoThreads) {
  const auto buffer = std::make_unique<CaptureBuffer<256>>();
  constexpr int kBlocks = 2'000;
  constexpr int kBlock = 64;
  std::jthread callback{[&] {
    std::array<float, kBlock> block{};
    for (int i = 0; i < kBlocks; ++i) {
      block.fill(static_cast<float>(i));
      buffer->write(block, 1, false);
      if (i % 8 == 0) std::this_thread::yield();
    }
  }};
  std::int64_t taken = 0;
  float last = 0.0F;
  while (taken + buffer->lost() < kBlocks * kBlock) {
    while (const auto sample = buffer->try_pop()) {
      EXPECT_GE(*sample, last);
      last = *sample;
      ++taken;
    }
  }
  callback.join();
  while (buffer->try_pop()) ++taken;
  EXPECT_EQ(taken + buffer->lost(), kBlocks * kBlock);
}

}  // namespace
}  // namespace bimodal::runner
