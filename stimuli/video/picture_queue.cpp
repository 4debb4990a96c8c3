#include "stimuli/video/picture_queue.hpp"

#include <utility>

namespace bimodal {

PictureQueue::PictureQueue(Work work) : work_{std::move(work)}, thread_{[this] { serve(); }} {}

PictureQueue::~PictureQueue() {
  close(true);
}

void PictureQueue::add(const Image& picture) {
  std::unique_lock lock{mutex_};
  changed_.wait(lock, [this] { return waiting_.size() < kMostWaiting || failure_; });
  if (failure_) std::rethrow_exception(failure_);
  Image copy;
  if (!spare_.empty()) {
    copy = std::move(spare_.back());
    spare_.pop_back();
  }
  lock.unlock();
  copy = picture;
  lock.lock();
  waiting_.push_back(std::move(copy));
  changed_.notify_all();
}

void PictureQueue::finish() {
  close(false);
  if (failure_) std::rethrow_exception(failure_);
}

void PictureQueue::close(bool dropping) {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock{mutex_};
    if (dropping) waiting_.clear();
    closing_ = true;
    changed_.notify_all();
  }
  thread_.join();
}

void PictureQueue::serve() {
  std::unique_lock lock{mutex_};
  for (;;) {
    changed_.wait(lock, [this] { return !waiting_.empty() || closing_; });
    if (waiting_.empty()) return;
    Image picture = std::move(waiting_.front());
    waiting_.pop_front();
    changed_.notify_all();
    lock.unlock();
    try {
      work_(picture);
    } catch (...) {
      lock.lock();
      failure_ = std::current_exception();
      changed_.notify_all();
      return;
    }
    lock.lock();
    spare_.push_back(std::move(picture));
  }
}

}  // namespace bimodal
