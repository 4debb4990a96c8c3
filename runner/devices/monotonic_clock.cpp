#include "runner/devices/monotonic_clock.hpp"

#include <cerrno>
#include <cstdint>
#include <ctime>

namespace bimodal::runner {
namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

}  // namespace

Instant MonotonicClock::now() const {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return Instant{Duration{time.tv_sec * kNanosecondsPerSecond + time.tv_nsec}};
}

void sleep_until(Instant instant) {
  const auto since_start = instant.time_since_epoch().count();
  if (since_start <= 0) return;
  const timespec until{.tv_sec = since_start / kNanosecondsPerSecond,
                       .tv_nsec = since_start % kNanosecondsPerSecond};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

}  // namespace bimodal::runner
