#include "runner/devices/triggers/signal_agenda.hpp"

#include <algorithm>

namespace bimodal::runner {

bool SignalAgenda::add(const TriggerSignal& signal) noexcept {
  if (count_ == kMost) return false;
  auto* const end = signals_.begin() + count_;
  auto* const place = std::upper_bound(
      signals_.begin(), end, signal, [](const TriggerSignal& a, const TriggerSignal& b) {
        return a.planned < b.planned;
      });
  std::move_backward(place, end, end + 1);
  *place = signal;
  ++count_;
  return true;
}

std::optional<Instant> SignalAgenda::next() const noexcept {
  if (count_ == 0) return reset_;
  return reset_ ? std::min(*reset_, signals_.front().planned) : signals_.front().planned;
}

std::optional<SignalAgenda::Task> SignalAgenda::take(Instant now) noexcept {
  if (count_ > 0 && signals_.front().planned <= now &&
      (!reset_ || signals_.front().planned <= *reset_)) {
    const Task task{signals_.front()};
    std::move(signals_.begin() + 1, signals_.begin() + count_, signals_.begin());
    --count_;
    return task;
  }
  if (!reset_ || *reset_ > now) return std::nullopt;
  reset_.reset();
  return Task{};
}

}  // namespace bimodal::runner
