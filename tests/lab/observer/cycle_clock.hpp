#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lab {

/// When the frames of a sound server's stream pass, from the instants at which its cycles were seen
/// to begin: a cycle may be seen late but not early, and after an overrun all of them come later.
/// So the median of the cycles around it tells where a cycle lies. The server's own estimate is not
/// used: after an overrun it swings for seconds.
///
/// `add` is called by one thread; the others by any. Nothing allocates after construction.
class CycleClock {
 public:
  CycleClock(std::size_t most_cycles, double frames_per_second);

  /// That the cycle whose first frame this is was seen to begin. Without room it is left out.
  void add(std::int64_t frame, std::int64_t seen_ns) noexcept;

  /// When a frame passed; needs at least one cycle.
  [[nodiscard]] std::int64_t instant_of(std::int64_t frame) const noexcept;

  /// The frame that passed at an instant; needs at least one cycle.
  [[nodiscard]] std::int64_t frame_at(std::int64_t instant_ns) const noexcept;

  [[nodiscard]] std::size_t count() const noexcept {
    return count_.load(std::memory_order_acquire);
  }

 private:
  struct Cycle {
    std::int64_t frame = 0;
    std::int64_t seen_ns = 0;
  };

  /// When frame 0 would have passed, as the cycles around the `index`th tell.
  [[nodiscard]] std::int64_t origin_ns(std::size_t index) const noexcept;

  template <typename Of>
  [[nodiscard]] std::size_t last_not_after(std::int64_t value, Of of) const noexcept;

  std::vector<Cycle> cycles_;
  std::atomic<std::size_t> count_{0};
  double frame_ns_;
};

}  // namespace lab
