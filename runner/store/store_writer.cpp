#include "runner/store/store_writer.hpp"

#include <utility>

#include "runner/realtime/urgency.hpp"
#include "runner/store/store_error.hpp"

namespace bimodal::runner {

StoreWriter::StoreWriter(SessionStore& store) : store_{store}, thread_{[this] { work(); }} {}

StoreWriter::~StoreWriter() {
  {
    const std::lock_guard lock{mutex_};
    closing_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

template <typename Result>
std::future<Result> StoreWriter::enqueue(std::packaged_task<Result()> task) {
  auto stored = task.get_future();
  {
    const std::lock_guard lock{mutex_};
    tasks_.emplace_back(std::move(task));
  }
  changed_.notify_one();
  return stored;
}

std::future<Duration> StoreWriter::add(std::int64_t session, TrialRecord trial) {
  using Steady = std::chrono::steady_clock;
  return enqueue(std::packaged_task<Duration()>{
      [this, session, trial = std::move(trial), asked = Steady::now()]() -> Duration {
        store_.add(session, trial);
        return Steady::now() - asked;
      }});
}

std::future<void> StoreWriter::add(std::int64_t session, PlanRecord planned) {
  return enqueue(std::packaged_task<void()>{
      [this, session, planned = std::move(planned)] { store_.add(session, planned); }});
}

std::future<void> StoreWriter::add(std::int64_t session, EventRecord event) {
  return enqueue(std::packaged_task<void()>{
      [this, session, event = std::move(event)] { store_.add(session, event); }});
}

bool StoreWriter::is_idle() {
  const std::lock_guard lock{mutex_};
  return tasks_.empty();
}

void StoreWriter::work() {
  make_urgent(Urgency::Storing);
  while (true) {
    std::packaged_task<void()> task;
    {
      std::unique_lock lock{mutex_};
      changed_.wait(lock, [this] { return closing_ || !tasks_.empty(); });
      if (tasks_.empty()) return;
      task = std::move(tasks_.front());
      tasks_.pop_front();
    }
    task();
    if (!is_idle()) continue;
    try {
      store_.settle();
    } catch (const StoreError&) {
      // Nothing is lost, and the next transaction meets the same disk.
    }
  }
}

}  // namespace bimodal::runner
