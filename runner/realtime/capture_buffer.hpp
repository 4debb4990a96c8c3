#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "runner/realtime/spsc_queue.hpp"

namespace bimodal::runner {

/// Carries the sound of an input from the audio callback to the thread that stores it. `write`
/// belongs to the callback: it never locks, allocates, throws or prints; `try_pop` belongs to one
/// other thread, `lost` to any. What does not fit is lost, and counted. `Capacity` in samples, a
/// power of two.
template <std::size_t Capacity>
class CaptureBuffer {
 public:
  /// Of every frame the first `taken` channels are taken.
  explicit CaptureBuffer(std::size_t taken = 1) : taken_{taken} {}

  /// Takes what arrived: frame after frame, `channels` >= taken samples each. A frame is taken
  /// whole or lost. `overflow`: the device has itself lost frames before these, nobody knows how
  /// many; counts as one.
  void write(std::span<const float> input, std::size_t channels, bool overflow) noexcept {
    std::int64_t lost = overflow ? 1 : 0;
    for (std::size_t at = 0; at < input.size(); at += channels) {
      if (queue_.room() < taken_) {
        ++lost;
        continue;
      }
      for (std::size_t channel = 0; channel < taken_; ++channel) {
        static_cast<void>(queue_.try_push(input[at + channel]));
      }
    }
    if (lost > 0) lost_.fetch_add(lost, std::memory_order_relaxed);
  }

  /// The next sample: of `taken` channels those of one frame follow each other.
  [[nodiscard]] std::optional<float> try_pop() noexcept { return queue_.try_pop(); }

  /// Frames since the beginning that never arrived.
  [[nodiscard]] std::int64_t lost() const noexcept { return lost_.load(std::memory_order_relaxed); }

 private:
  SpscQueue<float, Capacity> queue_;
  std::size_t taken_;
  std::atomic<std::int64_t> lost_{0};
};

}  // namespace bimodal::runner
