#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "runner/preparation/trial_source.hpp"

namespace bimodal::runner {

/// Prepares trials on a thread of its own, a few ahead of the session.
class PreparationQueue final : public TrialSource {
 public:
  /// Prepares one trial; made and called on the queue's own thread (OpenGL contexts belong to it).
  using Prepare = std::function<PreparedTrial(const protocols::PlannedTrial&, const Checkpoint&)>;

  /// Whether preparing gives way to everything else on the machine (niceness 10), as it must beside
  /// a real presentation.
  enum class Priority { Yielding, Equal };

  static constexpr std::size_t kAhead = 3;

  /// At most `ahead` prepared trials are kept.
  PreparationQueue(std::vector<protocols::PlannedTrial> plan,
                   std::function<Prepare()> make_prepare,
                   std::size_t ahead = kAhead,
                   Priority priority = Priority::Yielding);
  ~PreparationQueue() override;
  PreparationQueue(const PreparationQueue&) = delete;
  PreparationQueue& operator=(const PreparationQueue&) = delete;
  PreparationQueue(PreparationQueue&&) = delete;
  PreparationQueue& operator=(PreparationQueue&&) = delete;

  [[nodiscard]] bool ready() override;
  [[nodiscard]] PreparedTrial next() override;
  void hold() override;
  void release() override;

 private:
  /// Ends preparing in the middle of a trial.
  struct Closing {};

  void work(const std::vector<protocols::PlannedTrial>& plan,
            const std::function<Prepare()>& make_prepare);
  [[nodiscard]] bool await_room();
  /// Throws Closing if what is being prepared is not wanted any more.
  void await_release();
  void add(PreparedTrial trial);

  std::size_t ahead_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<PreparedTrial> prepared_;
  std::exception_ptr failure_;
  bool held_ = false;
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace bimodal::runner
