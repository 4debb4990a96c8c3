#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace bimodal {

/// Does `count` independent pieces of work on two threads. `make_worker` is called once a thread,
/// on it, and returns what does a piece, given its index; the pieces come in any order. Rethrows
/// the first exception, after both have stopped.
template <typename MakeWorker>
void side_by_side(std::size_t count, const MakeWorker& make_worker) {
  constexpr std::size_t kThreads = 2;
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      auto worker = make_worker();
      for (std::size_t i = next++; i < count; i = next++) worker(i);
    } catch (...) {
      const std::scoped_lock lock{mutex};
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < kThreads && i < count; ++i) threads.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace bimodal
