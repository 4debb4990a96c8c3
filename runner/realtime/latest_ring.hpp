#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace bimodal::runner {

/// Carries the most recent `Capacity` values from one producer thread to one consumer thread
/// without locks, allocation or exceptions. Unlike SpscQueue it never refuses: a value that was not
/// taken in time is overwritten, and the consumer goes on with the oldest that is left. For
/// measurements that arrive all the time and of which only the recent ones matter.
///
/// `push` may be called by the producer only, `try_pop` by the consumer only.
template <typename T, std::size_t Capacity>
class LatestRing {
  static_assert(Capacity > 0 && (Capacity & (Capacity - 1)) == 0, "indices wrap by masking");
  static_assert(std::is_trivially_copyable_v<T> && std::is_default_constructible_v<T>);
  static_assert(sizeof(T) % sizeof(std::uint64_t) == 0, "a value is copied in words of 64 bits");

 public:
  void push(const T& value) noexcept {
    const auto words = std::bit_cast<Words>(value);
    const auto index = written_.load(std::memory_order_relaxed);
    Slot& slot = slots_[index & kMask];
    slot.version.store(2 * index + 1, std::memory_order_relaxed);  // odd: being written
    for (std::size_t i = 0; i < kWords; ++i) {
      slot.words[i].store(words[i], std::memory_order_release);  // not before the odd version
    }
    slot.version.store(2 * index + 2, std::memory_order_release);
    written_.store(index + 1, std::memory_order_release);
  }

  [[nodiscard]] std::optional<T> try_pop() noexcept {
    while (true) {
      const auto written = written_.load(std::memory_order_acquire);
      if (next_ == written) return std::nullopt;
      if (written - next_ > Capacity) next_ = written - Capacity;
      const Slot& slot = slots_[next_ & kMask];
      const auto wanted = 2 * next_ + 2;
      Words words{};
      const bool complete = slot.version.load(std::memory_order_acquire) == wanted;
      for (std::size_t i = 0; i < kWords; ++i) {
        words[i] = slot.words[i].load(std::memory_order_acquire);
      }
      const bool unchanged = slot.version.load(std::memory_order_relaxed) == wanted;
      ++next_;
      if (!complete || !unchanged) continue;  // overwritten meanwhile
      return std::bit_cast<T>(words);
    }
  }

 private:
  static constexpr std::size_t kMask = Capacity - 1;
  static constexpr std::size_t kWords = sizeof(T) / sizeof(std::uint64_t);
  static constexpr std::size_t kCacheLine = 64;
  using Words = std::array<std::uint64_t, kWords>;

  struct Slot {
    std::atomic<std::uint64_t> version{0};
    std::array<std::atomic<std::uint64_t>, kWords> words{};
  };

  std::array<Slot, Capacity> slots_{};
  alignas(kCacheLine) std::atomic<std::uint64_t> written_{0};
  alignas(kCacheLine) std::uint64_t next_ = 0;  ///< the consumer's
};

}  // namespace bimodal::runner
