#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "runner/timing/input_stamp.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// The instant nearest to `near` whose milliseconds on CLOCK_MONOTONIC are `milliseconds` modulo
/// 2^32 (they come round every 49.7 days). Window systems send times so.
[[nodiscard]] Instant unwrapped(std::uint32_t milliseconds, Instant near);

/// Puts the millisecond stamps that come with the events of a window system on the session clock.
///
/// Where the stamps are those of CLOCK_MONOTONIC, as on this machine's own X server, each is judged
/// for itself: not later than its event was noticed, nor earlier than the last look that did not
/// find it, less 100 ms. Others are taken to come from a clock of the same pace but another origin
/// (a server on another machine) if the last 8 at least have advanced with the session clock, to 50
/// ms; the origin then follows from the event of the last 16 that took the
/// shortest time to be noticed. Stamps that stand still or jump are refused.
///
/// Allocates nothing. Not for concurrent use.
class MillisecondClock {
 public:
  /// Xorg may count a clock that itself advances in steps of up to a millisecond, hence two.
  static constexpr Duration kGrain = std::chrono::milliseconds{2};
  static constexpr Duration kSlack = std::chrono::milliseconds{100};
  static constexpr Duration kStep = std::chrono::milliseconds{50};
  static constexpr std::size_t kFewest = 8;
  static constexpr std::size_t kMost = 16;

  explicit MillisecondClock(std::string_view source) : source_{source} {}

  /// When that was pressed which carries the stamp `milliseconds`, was noticed at `noticed` and not
  /// yet `unnoticed` earlier. Absent: the stamp tells nothing better than that.
  [[nodiscard]] std::optional<InputStamp> stamp(std::uint32_t milliseconds,
                                                Instant noticed,
                                                Duration unnoticed);

 private:
  struct Reading {
    Instant counted;   ///< the stamp, unwrapped next to the reading before it
    Duration delay{};  ///< from `counted` to the notice
    Duration unnoticed{};
  };

  [[nodiscard]] std::optional<InputStamp> mapped(const Reading& reading, Instant noticed) const;
  [[nodiscard]] Reading read(std::uint32_t milliseconds, Instant noticed, Duration unnoticed);
  [[nodiscard]] const Reading& recent(std::size_t age) const;

  std::string_view source_;
  std::array<Reading, kMost> ring_{};
  std::size_t next_ = 0;
  std::size_t size_ = 0;
};

}  // namespace bimodal::runner
