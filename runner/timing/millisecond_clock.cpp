#include "runner/timing/millisecond_clock.hpp"

#include <algorithm>
#include <chrono>

namespace bimodal::runner {

Instant unwrapped(std::uint32_t milliseconds, Instant near) {
  const auto whole = std::chrono::floor<std::chrono::milliseconds>(near.time_since_epoch());
  const auto ahead = milliseconds - static_cast<std::uint32_t>(whole.count());
  return Instant{whole + std::chrono::milliseconds{static_cast<std::int32_t>(ahead)}};
}

std::optional<InputStamp> MillisecondClock::stamp(std::uint32_t milliseconds,
                                                  Instant noticed,
                                                  Duration unnoticed) {
  const auto counted = unwrapped(milliseconds, noticed);
  if (counted <= noticed && counted >= noticed - unnoticed - kSlack) {
    return stamp_of_count(counted, kGrain, noticed, source_);
  }
  const auto reading = read(milliseconds, noticed, unnoticed);
  return size_ < kFewest ? std::nullopt : mapped(reading, noticed);
}

MillisecondClock::Reading MillisecondClock::read(std::uint32_t milliseconds,
                                                 Instant noticed,
                                                 Duration unnoticed) {
  Reading reading{.counted = unwrapped(milliseconds, noticed), .unnoticed = unnoticed};
  if (size_ > 0) {
    const auto& last = recent(0);
    const auto since = noticed - (last.counted + last.delay);
    reading.counted = unwrapped(milliseconds, last.counted + since);
  }
  reading.delay = noticed - reading.counted;
  for (std::size_t age = 0; age < size_; ++age) {
    const auto change = std::chrono::abs(reading.delay - recent(age).delay);
    if (change > kStep + unnoticed + recent(age).unnoticed) size_ = 0;
  }
  ring_[next_] = reading;
  next_ = (next_ + 1) % kMost;
  size_ = std::min(size_ + 1, kMost);
  return reading;
}

const MillisecondClock::Reading& MillisecondClock::recent(std::size_t age) const {
  return ring_[(next_ + kMost - 1 - age) % kMost];
}

/// The origin is known to the time for which the quickest event went unnoticed, and a grain.
std::optional<InputStamp> MillisecondClock::mapped(const Reading& reading, Instant noticed) const {
  auto quickest = reading;
  for (std::size_t age = 0; age < size_; ++age) {
    if (recent(age).delay < quickest.delay) quickest = recent(age);
  }
  const auto at = std::min(reading.counted + quickest.delay + kGrain, noticed);
  const auto earliest = reading.counted + quickest.delay - quickest.unnoticed - kGrain;
  if (at - earliest >= reading.unnoticed) return std::nullopt;
  return InputStamp{.at = at, .uncertainty = at - earliest, .source = source_};
}

}  // namespace bimodal::runner
