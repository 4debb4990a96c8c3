#include "runner/store/store_writer.hpp"

#include <utility>

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

std::future<void> StoreWriter::add(std::int64_t session, TrialRecord trial) {
  return enqueue(std::packaged_task<void()>{
      [this, session, trial = std::move(trial)] { store_.add(session, trial); }});
}

std::future<void> StoreWriter::add(std::int64_t session, PlanRecord planned) {
  return enqueue(std::packaged_task<void()>{
      [this, session, planned = std::move(planned)] { store_.add(session, planned); }});
}

std::future<void> StoreWriter::add(std::int64_t session, EventRecord event) {
  return enqueue(std::packaged_task<void()>{
      [this, session, event = std::move(event)] { store_.add(session, event); }});
}

std::future<void> StoreWriter::enqueue(std::packaged_task<void()> task) {
  auto stored = task.get_future();
  {
    const std::lock_guard lock{mutex_};
    tasks_.push_back(std::move(task));
  }
  changed_.notify_one();
  return stored;
}

void StoreWriter::work() {
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
  }
}

}  // namespace bimodal::runner
