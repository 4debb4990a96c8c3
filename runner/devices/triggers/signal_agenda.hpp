#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "runner/devices/triggers/trigger_port.hpp"

namespace bimodal::runner {

/// What a sender is still to do, and when. Signals of the same instant keep their order. A reset
/// follows the last code only: a code that comes before it puts it off.
class SignalAgenda {
 public:
  /// False if the agenda is full.
  [[nodiscard]] bool add(const TriggerSignal& signal) noexcept;

  /// Instead of a reset that is still to come.
  void reset_at(Instant at) noexcept { reset_ = at; }

  /// When there is something to be done next; absent: nothing is.
  [[nodiscard]] std::optional<Instant> next() const noexcept;

  /// A thing to be done: a signal, or a reset.
  struct Task {
    std::optional<TriggerSignal> signal;  ///< absent: reset
  };

  /// Takes the next thing that is due at `now`, if any is.
  [[nodiscard]] std::optional<Task> take(Instant now) noexcept;

 private:
  static constexpr std::size_t kMost = 32;

  std::array<TriggerSignal, kMost> signals_{};  ///< the first `count_`, by their instants
  std::size_t count_ = 0;
  std::optional<Instant> reset_;
};

}  // namespace bimodal::runner
