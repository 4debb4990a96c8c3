#pragma once

#include <vector>

#include "runner/preparation/trial_source.hpp"

namespace bimodal::runner {

/// Prepares each trial when it is asked for: for rehearsals, where time does not pass meanwhile.
class ImmediateTrials final : public TrialSource {
 public:
  /// `plan` and `preparer` are borrowed.
  ImmediateTrials(const std::vector<protocols::PlannedTrial>& plan, TrialPreparer& preparer)
      : plan_{plan}, preparer_{preparer} {}

  [[nodiscard]] bool ready() override { return true; }

  [[nodiscard]] PreparedTrial next() override { return preparer_.prepare(plan_.at(next_++)); }

  void hold() override {}

  void release() override {}

 private:
  const std::vector<protocols::PlannedTrial>&
      plan_;                 // NOLINT(cppcoreguidelines-avoid-const-or-ref-data-members): borrowed
  TrialPreparer& preparer_;  // NOLINT(cppcoreguidelines-avoid-const-or-ref-data-members): borrowed
  std::size_t next_ = 0;
};

}  // namespace bimodal::runner
