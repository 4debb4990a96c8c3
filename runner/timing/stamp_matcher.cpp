#include "runner/timing/stamp_matcher.hpp"

namespace bimodal::runner {

void StampMatcher::add(std::uint32_t code, Instant at) {
  ring_[next_] = {.code = code, .at = at, .waits = true};
  next_ = (next_ + 1) % kMost;
}

std::optional<Instant> StampMatcher::take(std::uint32_t code, Instant noticed, Duration unnoticed) {
  const auto earliest = noticed - unnoticed - kSlack;
  for (std::size_t age = 0; age < kMost; ++age) {
    auto& press = ring_[(next_ + age) % kMost];  // the oldest first
    if (!press.waits || press.code != code || press.at < earliest || press.at > noticed) continue;
    press.waits = false;
    return press.at;
  }
  return std::nullopt;
}

}  // namespace bimodal::runner
