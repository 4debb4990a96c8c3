#include "runner/timing/millisecond_clock.hpp"

#include <chrono>

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

std::uint32_t milliseconds_of(Instant at) {
  return static_cast<std::uint32_t>(
      std::chrono::floor<std::chrono::milliseconds>(at.time_since_epoch()).count());
}

TEST(Unwrapped, IsTheNearestInstantWithThoseMilliseconds) {
  EXPECT_EQ(unwrapped(1000, Instant{1003ms}), Instant{1000ms});
  EXPECT_EQ(unwrapped(1005, Instant{1003ms}), Instant{1005ms});
}

TEST(Unwrapped, GoesOnBeyond49Days) {
  const auto turn = Instant{4'294'967'296ms};
  EXPECT_EQ(unwrapped(5, turn + 7ms), turn + 5ms);
  EXPECT_EQ(unwrapped(4'294'967'290U, turn + 7ms), turn - 6ms);
  EXPECT_EQ(unwrapped(3, turn - 2ms), turn + 3ms);
}

TEST(MillisecondClock, TakesStampsOfTheSessionClockAsTheyAre) {
  MillisecondClock clock{"server"};
  const auto stamp = clock.stamp(12'000, Instant{12'009ms}, 15ms);
  ASSERT_TRUE(stamp);
  EXPECT_EQ(stamp->at, Instant{12'002ms});
  EXPECT_EQ(stamp->uncertainty, 2ms);
  EXPECT_EQ(stamp->source, "server");
}

TEST(MillisecondClock, NeverStampsLaterThanTheNotice) {
  MillisecondClock clock{"server"};
  const auto stamp = clock.stamp(12'000, Instant{12'000ms + 500us}, 1ms);
  ASSERT_TRUE(stamp);
  EXPECT_EQ(stamp->at, Instant{12'000ms + 500us});
  EXPECT_EQ(stamp->uncertainty, 500us);
}

TEST(MillisecondClock, RefusesAStampFromTheFutureOrLongBeforeTheLastLook) {
  MillisecondClock clock{"server"};
  EXPECT_FALSE(clock.stamp(12'001, Instant{12'000ms}, 16ms));
  EXPECT_FALSE(clock.stamp(11'800, Instant{12'000ms}, 16ms));
  EXPECT_TRUE(clock.stamp(11'900, Instant{12'000ms}, 16ms));
}

TEST(MillisecondClock, RefusesTheZerosOfVirtualKeyboardsHoweverFastTheyCome) {
  MillisecondClock clock{"server"};
  for (auto now = Instant{100s}; now < Instant{120s}; now += 33ms) {
    ASSERT_FALSE(clock.stamp(0, now, 16ms));
  }
}

TEST(MillisecondClock, FindsTheOriginOfAnotherClockAfterEightStamps) {
  constexpr Duration kAhead = 987'654'321ms;
  Random random{5};
  MillisecondClock clock{"server"};
  auto pressed = Instant{1000s};
  int stamped = 0;
  for (int press = 0; press < 200; ++press) {
    pressed += 100ms + std::chrono::microseconds{random.below(900'000)};
    const auto unnoticed = std::chrono::microseconds{500 + random.below(16'000)};
    const auto noticed = pressed + std::chrono::microseconds{
                                       random.below(static_cast<std::uint64_t>(unnoticed.count()))};
    const auto stamp = clock.stamp(milliseconds_of(pressed + kAhead), noticed, unnoticed);
    if (press < 7) {
      ASSERT_FALSE(stamp);
    }
    if (!stamp) continue;
    ++stamped;
    ASSERT_LE(stamp->at, noticed);
    ASSERT_GE(stamp->at, pressed - 1ms);
    ASSERT_LE(stamp->at - stamp->uncertainty, pressed);
    ASSERT_LT(stamp->uncertainty, unnoticed);
  }
  EXPECT_GT(stamped, 80);
}

TEST(MillisecondClock, BeginsAnewWhenTheOtherClockJumps) {
  MillisecondClock clock{"server"};
  auto now = Instant{1000s};
  const auto press = [&](Duration ahead, Duration waited) {
    now += 300ms;
    return clock.stamp(milliseconds_of(now + ahead), now + waited, 2 * waited);
  };
  for (int k = 0; k < 7; ++k) EXPECT_FALSE(press(5000s, 1ms));
  EXPECT_TRUE(press(5000s, 8ms));
  for (int k = 0; k < 7; ++k) EXPECT_FALSE(press(9000s, 1ms));
  EXPECT_TRUE(press(9000s, 8ms));
}

TEST(MillisecondClock, LeavesItToThePollWhereTheOriginIsKnownNoBetter) {
  MillisecondClock clock{"server"};
  auto now = Instant{1000s};
  for (int k = 0; k < 20; ++k) {
    now += 300ms;
    EXPECT_FALSE(clock.stamp(milliseconds_of(now + 5000s), now + 1ms, 2ms));
  }
}

}  // namespace
}  // namespace bimodal::runner
