#include "runner/preparation/preparation_queue.hpp"

#include <utility>

#include <sys/resource.h>
#include <unistd.h>

namespace bimodal::runner {

namespace {

/// Lets presentation and sound go first, also before the threads that OpenGL starts from this one.
void yield_to_presentation() {
  constexpr int kNiceness = 10;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNiceness);
}

}  // namespace

PreparationQueue::PreparationQueue(std::vector<protocols::PlannedTrial> plan,
                                   std::function<Prepare()> make_prepare,
                                   std::size_t ahead,
                                   Priority priority)
    : ahead_{ahead},
      thread_{[this, priority, plan = std::move(plan), make_prepare = std::move(make_prepare)] {
        if (priority == Priority::Yielding) yield_to_presentation();
        work(plan, make_prepare);
      }} {}

PreparationQueue::~PreparationQueue() {
  {
    const std::lock_guard lock{mutex_};
    closing_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

bool PreparationQueue::ready() {
  const std::lock_guard lock{mutex_};
  return !prepared_.empty() || failure_ != nullptr;
}

PreparedTrial PreparationQueue::next() {
  std::unique_lock lock{mutex_};
  changed_.wait(lock, [this] { return !prepared_.empty() || failure_ != nullptr; });
  if (prepared_.empty()) std::rethrow_exception(failure_);
  auto trial = std::move(prepared_.front());
  prepared_.pop_front();
  lock.unlock();
  changed_.notify_all();
  return trial;
}

void PreparationQueue::hold() {
  const std::lock_guard lock{mutex_};
  held_ = true;
}

void PreparationQueue::release() {
  {
    const std::lock_guard lock{mutex_};
    held_ = false;
  }
  changed_.notify_all();
}

bool PreparationQueue::await_room() {
  std::unique_lock lock{mutex_};
  changed_.wait(lock, [this] { return closing_ || (!held_ && prepared_.size() < ahead_); });
  return !closing_;
}

void PreparationQueue::await_release() {
  std::unique_lock lock{mutex_};
  changed_.wait(lock, [this] { return closing_ || !held_; });
  if (closing_) throw Closing{};
}

void PreparationQueue::add(PreparedTrial trial) {
  {
    const std::lock_guard lock{mutex_};
    prepared_.push_back(std::move(trial));
  }
  changed_.notify_all();
}

void PreparationQueue::work(const std::vector<protocols::PlannedTrial>& plan,
                            const std::function<Prepare()>& make_prepare) {
  try {
    const auto prepare = make_prepare();
    for (const auto& trial : plan) {
      if (!await_room()) return;
      add(prepare(trial, [this] { await_release(); }));
    }
  } catch (const Closing&) {
    return;
  } catch (...) {  // whatever it is, the session loop rethrows it
    {
      const std::lock_guard lock{mutex_};
      failure_ = std::current_exception();
    }
    changed_.notify_all();
  }
}

}  // namespace bimodal::runner
