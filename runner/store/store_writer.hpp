#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <thread>

#include "runner/store/session_store.hpp"

namespace bimodal::runner {

/// Runs the transactions of a store on a thread of its own, in the order of the calls, so that the
/// presenting thread never waits for a disk while a stimulus is on the screen; before ordinary
/// threads, where the system allows it. When nothing is left to do it lets the store settle. The
/// session loop awaits the returned future before the next trial begins. Used by one thread.
class StoreWriter {
 public:
  explicit StoreWriter(SessionStore& store);
  ~StoreWriter();  ///< finishes what was asked for
  StoreWriter(const StoreWriter&) = delete;
  StoreWriter& operator=(const StoreWriter&) = delete;
  StoreWriter(StoreWriter&&) = delete;
  StoreWriter& operator=(StoreWriter&&) = delete;

  /// The future holds the StoreError if the transaction failed; of a trial, how long after the call
  /// it was committed.
  [[nodiscard]] std::future<Duration> add(std::int64_t session, TrialRecord trial);
  [[nodiscard]] std::future<void> add(std::int64_t session, PlanRecord planned);
  [[nodiscard]] std::future<void> add(std::int64_t session, EventRecord event);

 private:
  template <typename Result>
  [[nodiscard]] std::future<Result> enqueue(std::packaged_task<Result()> task);
  void work();
  /// Nothing is asked for.
  [[nodiscard]] bool is_idle();

  SessionStore& store_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::packaged_task<void()>> tasks_;
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace bimodal::runner
