#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "stimuli/picture/image.hpp"

namespace bimodal {

/// Hands pictures in order to work that is done on a thread of its own, so that the next one is
/// drawn while the last one is encoded. All functions are for the thread that made it.
class PictureQueue {
 public:
  using Work = std::function<void(const Image&)>;

  /// So many wait at most; then add() does.
  static constexpr std::size_t kMostWaiting = 4;

  explicit PictureQueue(Work work);
  /// Drops what waits.
  ~PictureQueue();
  PictureQueue(const PictureQueue&) = delete;
  PictureQueue& operator=(const PictureQueue&) = delete;
  PictureQueue(PictureQueue&&) = delete;
  PictureQueue& operator=(PictureQueue&&) = delete;

  /// Copies the picture. Throws what an earlier picture's work has thrown.
  void add(const Image& picture);

  /// Waits until all work is done; throws what it has thrown. Nothing can be added afterwards.
  void finish();

 private:
  void serve();
  void close(bool dropping);

  Work work_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Image> waiting_;
  std::vector<Image> spare_;  ///< memory of pictures that are done
  std::exception_ptr failure_;
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace bimodal
