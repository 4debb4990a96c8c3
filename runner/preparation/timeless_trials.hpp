#pragma once

#include <utility>
#include <vector>

#include "runner/preparation/preparation_queue.hpp"

namespace bimodal::runner {

/// For rehearsals, in whose virtual time preparing takes none: a trial always counts as ready, and
/// whoever asks for it waits. Prepared ahead all the same, while the trial before is being stored.
class TimelessTrials final : public TrialSource {
 public:
  TimelessTrials(std::vector<protocols::PlannedTrial> plan,
                 std::function<PreparationQueue::Prepare()> make_prepare)
      : queue_{std::move(plan),
               std::move(make_prepare),
               PreparationQueue::kAhead,
               PreparationQueue::Priority::Equal} {}

  [[nodiscard]] bool ready() override { return true; }

  [[nodiscard]] PreparedTrial next() override { return queue_.next(); }

  void hold() override {}

  void release() override {}

 private:
  PreparationQueue queue_;
};

}  // namespace bimodal::runner
