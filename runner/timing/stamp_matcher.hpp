#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// Finds the instant of an event among stamps that came by another way.
///
/// A stamp belongs to an event if it has the same code and lies between the last look that did not
/// find the event yet (less some slack for what passes it on) and the instant at which it was
/// noticed. Of several the oldest, because both ways keep their order. So neither a stamp without
/// an event (a key pressed in another window) nor an event without a stamp shifts those that
/// follow, and stamps on another clock match nothing.
///
/// Keeps the last 64 stamps; allocates nothing. Not for concurrent use.
class StampMatcher {
 public:
  static constexpr std::size_t kMost = 64;
  static constexpr Duration kSlack = std::chrono::milliseconds{50};

  /// A press of the key or button `code` at `at`, the earliest instant that its stamp allows. In
  /// the order of time.
  void add(std::uint32_t code, Instant at);

  /// The stamp of a press of `code` that was noticed at `noticed`, and not yet `unnoticed` earlier.
  /// Each stamp is given once.
  [[nodiscard]] std::optional<Instant> take(std::uint32_t code,
                                            Instant noticed,
                                            Duration unnoticed);

 private:
  struct Press {
    std::uint32_t code = 0;
    Instant at;
    bool waits = false;
  };

  std::array<Press, kMost> ring_{};
  std::size_t next_ = 0;
};

}  // namespace bimodal::runner
