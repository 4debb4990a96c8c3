#include "cycle_clock.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lab {

namespace {

constexpr std::size_t kAround = 7;  ///< cycles on either side

}  // namespace

CycleClock::CycleClock(std::size_t most_cycles, double frames_per_second)
    : cycles_(most_cycles), frame_ns_{1e9 / frames_per_second} {}

void CycleClock::add(std::int64_t frame, std::int64_t seen_ns) noexcept {
  const auto count = count_.load(std::memory_order_relaxed);
  if (count == cycles_.size()) return;
  cycles_[count] = {frame, seen_ns};
  count_.store(count + 1, std::memory_order_release);
}

std::int64_t CycleClock::instant_of(std::int64_t frame) const noexcept {
  const auto index = last_not_after(frame, [](const Cycle& cycle) { return cycle.frame; });
  return origin_ns(index) + std::llround(frame_ns_ * static_cast<double>(frame));
}

std::int64_t CycleClock::frame_at(std::int64_t instant_ns) const noexcept {
  const auto index = last_not_after(instant_ns, [](const Cycle& cycle) { return cycle.seen_ns; });
  return std::llround(static_cast<double>(instant_ns - origin_ns(index)) / frame_ns_);
}

std::int64_t CycleClock::origin_ns(std::size_t index) const noexcept {
  const auto first = index - std::min(index, kAround);
  const auto last = std::min(index + kAround + 1, count());
  std::array<std::int64_t, 2 * kAround + 1> origins{};
  for (auto i = first; i < last; ++i) {
    const double after = frame_ns_ * static_cast<double>(cycles_[i].frame);
    origins[i - first] = cycles_[i].seen_ns - std::llround(after);
  }
  auto* const middle = origins.begin() + (last - first) / 2;
  std::nth_element(origins.begin(), middle, origins.begin() + (last - first));
  return *middle;
}

template <typename Of>
std::size_t CycleClock::last_not_after(std::int64_t value, Of of) const noexcept {
  std::size_t low = 0;
  for (std::size_t high = count(); high - low > 1;) {
    const auto middle = (low + high) / 2;
    (of(cycles_[middle]) <= value ? low : high) = middle;
  }
  return low;
}

}  // namespace lab
