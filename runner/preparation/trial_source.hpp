#pragma once

#include "runner/preparation/trial_preparer.hpp"

namespace bimodal::runner {

/// Gives prepared trials in the order of the plan. Used by the session loop.
class TrialSource {
 public:
  TrialSource() = default;
  TrialSource(const TrialSource&) = delete;
  TrialSource& operator=(const TrialSource&) = delete;
  TrialSource(TrialSource&&) = delete;
  TrialSource& operator=(TrialSource&&) = delete;
  virtual ~TrialSource() = default;

  /// Whether next() will return at once.
  [[nodiscard]] virtual bool ready() = 0;

  /// The next trial, which may have to be waited for. Throws what preparing it threw.
  [[nodiscard]] virtual PreparedTrial next() = 0;

  /// Between hold() and release() preparation rests, so that it takes no time from a presentation.
  virtual void hold() = 0;
  virtual void release() = 0;
};

}  // namespace bimodal::runner
