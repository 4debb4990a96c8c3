#include "runner/devices/triggers/trigger_sender.hpp"

#include <ctime>
#include <exception>
#include <utility>

#include "runner/realtime/urgency.hpp"

namespace bimodal::runner {

namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

}  // namespace

TriggerSender::TriggerSender(std::unique_ptr<TriggerPort> port) : port_{std::move(port)} {
  sem_init(&something_new_, 0, 0);
  thread_ = std::thread{[this] { work(); }};
}

TriggerSender::~TriggerSender() {
  closing_ = true;
  sem_post(&something_new_);
  thread_.join();
  sem_destroy(&something_new_);
}

bool TriggerSender::post(const TriggerSignal& signal) noexcept {
  if (!signals_.try_push(signal)) return false;
  sem_post(&something_new_);
  return true;
}

void TriggerSender::work() {
  make_urgent(Urgency::Presenting);
  while (true) {
    const bool closing = closing_;  // before the queue is emptied: what was posted is seen
    while (const auto signal = signals_.try_pop()) {
      if (!agenda_.add(*signal)) report({.signal = *signal});
    }
    if (const auto task = agenda_.take(clock_.now())) {
      perform(*task);
    } else if (closing) {
      if (port_->reset_after()) static_cast<void>(port_->reset());
      return;
    } else {
      sleep_until_next();
    }
  }
}

void TriggerSender::sleep_until_next() {
  const auto next = agenda_.next();
  if (!next) {
    sem_wait(&something_new_);
    return;
  }
  const auto since_start = next->time_since_epoch().count();
  const timespec until{.tv_sec = since_start / kNanosecondsPerSecond,
                       .tv_nsec = since_start % kNanosecondsPerSecond};
  sem_clockwait(&something_new_, CLOCK_MONOTONIC, &until);  // or until something new has come
}

void TriggerSender::perform(const SignalAgenda::Task& task) {
  if (!task.signal) {
    static_cast<void>(port_->reset());  // the next signal tells if the port is lost
    return;
  }
  const auto before = clock_.now();
  bool arrived = false;
  try {
    arrived = port_->send(*task.signal, before);
  } catch (const std::exception&) {
    arrived = false;  // out of memory: the signal is reported as not sent
  }
  const auto after = clock_.now();
  if (!arrived) {
    report({.signal = *task.signal});
    return;
  }
  report({.signal = *task.signal, .sent = after, .uncertainty = after - before});
  if (const auto reset_after = port_->reset_after()) agenda_.reset_at(after + *reset_after);
}

/// Nobody may read; then the newest are lost, and count as not reported.
void TriggerSender::report(const TriggerReport& report) {
  static_cast<void>(reports_.try_push(report));
}

}  // namespace bimodal::runner
