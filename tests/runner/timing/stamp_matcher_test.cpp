#include "runner/timing/stamp_matcher.hpp"

#include <gtest/gtest.h>

#include "runner/timing/input_stamp.hpp"
#include "stimuli/base/random.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

constexpr std::uint32_t kA = 30;
constexpr std::uint32_t kB = 48;

TEST(StampMatcher, GivesAnEventTheStampOfItsCode) {
  StampMatcher matcher;
  matcher.add(kA, Instant{1000ms});
  matcher.add(kB, Instant{1001ms});
  EXPECT_EQ(matcher.take(kB, Instant{1010ms}, 10ms), Instant{1001ms});
  EXPECT_EQ(matcher.take(kA, Instant{1010ms}, 10ms), Instant{1000ms});
}

TEST(StampMatcher, GivesEachStampOnce) {
  StampMatcher matcher;
  matcher.add(kA, Instant{1000ms});
  EXPECT_TRUE(matcher.take(kA, Instant{1010ms}, 10ms));
  EXPECT_FALSE(matcher.take(kA, Instant{1011ms}, 10ms));
}

TEST(StampMatcher, KeepsTheOrderOfTwoPressesNoticedTogether) {
  StampMatcher matcher;
  matcher.add(kA, Instant{1000ms});
  matcher.add(kA, Instant{1080ms});
  EXPECT_EQ(matcher.take(kA, Instant{1100ms}, 100ms), Instant{1000ms});
  EXPECT_EQ(matcher.take(kA, Instant{1100ms}, 100ms), Instant{1080ms});
}

TEST(StampMatcher, IsNotShiftedByAStampWithoutAnEvent) {
  StampMatcher matcher;
  matcher.add(kA, Instant{1000ms});  // typed into another window
  matcher.add(kA, Instant{1300ms});
  EXPECT_EQ(matcher.take(kA, Instant{1301ms}, 1ms), Instant{1300ms});
}

TEST(StampMatcher, IsNotShiftedByAnEventWithoutAStamp) {
  StampMatcher matcher;
  EXPECT_FALSE(matcher.take(kA, Instant{1001ms}, 1ms));
  matcher.add(kA, Instant{1300ms});
  EXPECT_EQ(matcher.take(kA, Instant{1301ms}, 1ms), Instant{1300ms});
}

TEST(StampMatcher, MatchesNothingOnAnotherClockNorInTheFuture) {
  StampMatcher matcher;
  matcher.add(kA, Instant{});
  matcher.add(kA, Instant{1'700'000'000s});
  matcher.add(kA, Instant{1001ms + 1ns});
  EXPECT_FALSE(matcher.take(kA, Instant{1001ms}, 10ms));
}

TEST(StampMatcher, AllowsForTheTimeThatPassingOnTakes) {
  StampMatcher matcher;
  matcher.add(kA, Instant{1000ms});
  EXPECT_FALSE(matcher.take(kA, Instant{1051ms}, 1ms - 1ns));
  EXPECT_TRUE(matcher.take(kA, Instant{1051ms}, 1ms));
}

TEST(StampMatcher, ForgetsTheOldestOfMoreThanItsMemory) {
  StampMatcher matcher;
  for (std::size_t k = 0; k <= StampMatcher::kMost; ++k) {
    matcher.add(static_cast<std::uint32_t>(k), Instant{1s});
  }
  EXPECT_FALSE(matcher.take(0, Instant{1s}, 1ms));
  EXPECT_TRUE(matcher.take(1, Instant{1s}, 1ms));
  EXPECT_TRUE(matcher.take(StampMatcher::kMost, Instant{1s}, 1ms));
}

TEST(StampMatcher, NeverErrsWhereSomeStampsAndSomeEventsAreLost) {
  Random random{11};
  StampMatcher matcher;
  auto now = Instant{100s};
  int matched = 0;
  for (int press = 0; press < 5000; ++press) {
    now += 70ms + std::chrono::microseconds{random.below(400'000)};
    const auto code = static_cast<std::uint32_t>(30 + random.below(3));
    const auto unnoticed = std::chrono::microseconds{1 + random.below(16'000)};
    const auto noticed = now + unnoticed / 2;
    const bool has_stamp = random.below(10) != 0;
    const bool has_event = random.below(10) != 0;
    if (has_stamp) matcher.add(code, now);
    if (!has_event) continue;
    const auto found = matcher.take(code, noticed, unnoticed);
    ASSERT_EQ(found.has_value(), has_stamp) << press;
    if (!found) continue;
    ASSERT_EQ(*found, now) << press;
    ++matched;
  }
  EXPECT_GT(matched, 3500);
}

TEST(StampOfCount, LiesAtTheEndOfTheGrainButNotAfterTheNotice) {
  const auto early = stamp_of_count(Instant{1000ms}, 1ms, Instant{1010ms}, "compositor");
  EXPECT_EQ(early.at, Instant{1001ms});
  EXPECT_EQ(early.uncertainty, 1ms);
  EXPECT_EQ(early.source, "compositor");
  const auto late = stamp_of_count(Instant{1000ms}, 1ms, Instant{1000ms + 300us}, "compositor");
  EXPECT_EQ(late.at, Instant{1000ms + 300us});
  EXPECT_EQ(late.uncertainty, 300us);
}

}  // namespace
}  // namespace bimodal::runner
