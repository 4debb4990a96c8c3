#include "runner/realtime/latest_ring.hpp"

#include <thread>

#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

struct Twins {
  std::uint64_t first = 0;
  std::uint64_t second = 0;
};

TEST(LatestRing, GivesWhatWasPutInOrder) {
  LatestRing<Twins, 4> ring;
  EXPECT_FALSE(ring.try_pop().has_value());
  ring.push({1, 2});
  ring.push({3, 4});
  EXPECT_EQ(ring.try_pop()->first, 1U);
  EXPECT_EQ(ring.try_pop()->second, 4U);
  EXPECT_FALSE(ring.try_pop().has_value());
}

TEST(LatestRing, OverwritesTheOldest) {
  LatestRing<Twins, 4> ring;
  for (std::uint64_t i = 0; i < 11; ++i) ring.push({i, i});
  for (std::uint64_t i = 7; i < 11; ++i) EXPECT_EQ(ring.try_pop()->first, i);
  EXPECT_FALSE(ring.try_pop().has_value());
}

TEST(LatestRing, NeverGivesHalfAValueOrAnOldOneAcrossThreads) {
  constexpr std::uint64_t kLast = 50'000;
  LatestRing<Twins, 8> ring;
  const std::jthread producer{[&ring] {
    for (std::uint64_t i = 1; i <= kLast; ++i) ring.push({i, ~i});
  }};
  std::uint64_t latest = 0;
  while (latest < kLast) {
    const auto value = ring.try_pop();
    if (!value) {
      std::this_thread::yield();
      continue;
    }
    ASSERT_EQ(value->second, ~value->first);
    ASSERT_GT(value->first, latest);
    latest = value->first;
  }
}

}  // namespace
}  // namespace bimodal::runner
