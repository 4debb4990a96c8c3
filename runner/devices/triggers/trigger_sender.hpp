#pragma once

#include <atomic>
#include <memory>
#include <thread>

#include <semaphore.h>

#include "runner/devices/monotonic_clock.hpp"
#include "runner/devices/triggers/signal_agenda.hpp"
#include "runner/devices/triggers/trigger_line.hpp"
#include "runner/realtime/spsc_queue.hpp"

namespace bimodal::runner {

/// Sends the signals of one port at their instants, on a thread of its own that sleeps between
/// them (with real-time priority where the system allows it) and takes the time before and after
/// each: `sent` is the instant at which sending returned.
class TriggerSender final : public TriggerLine {
 public:
  explicit TriggerSender(std::unique_ptr<TriggerPort> port);

  /// What is not yet due is not sent any more, but a reset is.
  ~TriggerSender() override;
  TriggerSender(const TriggerSender&) = delete;
  TriggerSender& operator=(const TriggerSender&) = delete;
  TriggerSender(TriggerSender&&) = delete;
  TriggerSender& operator=(TriggerSender&&) = delete;

  [[nodiscard]] bool post(const TriggerSignal& signal) noexcept override;

  [[nodiscard]] std::optional<TriggerReport> next_report() noexcept override {
    return reports_.try_pop();
  }

  [[nodiscard]] std::string_view kind() const override { return port_->kind(); }

  [[nodiscard]] std::string description() const override { return port_->description(); }

 private:
  static constexpr std::size_t kQueue = 64;

  void work();
  void sleep_until_next();
  void perform(const SignalAgenda::Task& task);
  void report(const TriggerReport& report);

  std::unique_ptr<TriggerPort> port_;
  MonotonicClock clock_;
  SpscQueue<TriggerSignal, kQueue> signals_;  ///< from the presenting thread
  SpscQueue<TriggerReport, kQueue> reports_;  ///< and back to it
  SignalAgenda agenda_;                       ///< of the sending thread
  sem_t something_new_{};
  std::atomic<bool> closing_{false};
  std::thread thread_;
};

}  // namespace bimodal::runner
