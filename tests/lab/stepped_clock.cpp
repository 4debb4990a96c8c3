/// A wall clock that is set while a program runs: preloaded (LD_PRELOAD), it makes the program's
/// clock of the day jump an hour back 5 s after its start, and two hours on 5 s later.
/// CLOCK_MONOTONIC and every other clock stay what they are.
#include <ctime>

#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

namespace {

timespec read(clockid_t clock) {
  timespec time{};
  syscall(SYS_clock_gettime, clock, &time);
  return time;
}

const time_t kStart = read(CLOCK_MONOTONIC).tv_sec;

time_t step() {
  const auto since = read(CLOCK_MONOTONIC).tv_sec - kStart;
  return since < 5 ? 0 : since < 10 ? -3600 : 3600;
}

timespec wall_clock(clockid_t clock) {
  auto time = read(clock);
  time.tv_sec += step();
  return time;
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  const bool is_wall = clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE;
  if (!is_wall) return static_cast<int>(syscall(SYS_clock_gettime, clock, time));
  *time = wall_clock(clock);
  return 0;
}

int gettimeofday(timeval* time, void* /*zone*/) noexcept {
  const auto now = wall_clock(CLOCK_REALTIME);
  *time = {now.tv_sec, now.tv_nsec / 1000};
  return 0;
}

time_t time(time_t* time) noexcept {
  const auto now = wall_clock(CLOCK_REALTIME).tv_sec;
  if (time != nullptr) *time = now;
  return now;
}
}
