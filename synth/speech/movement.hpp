#pragma once

#include <span>
#include <vector>

#include "stimuli/base/quantity.hpp"
#include "synth/speech/dominance.hpp"

namespace bimodal::synth {

/// What the segments of an utterance claim of each control, in the segments' order. A segment may
/// make no claim on a control, but each control has at least one claim.
using ControlClaims = std::vector<std::vector<Claim>>;

/// How the controls of an utterance move, by one account of coarticulation (see Account).
class Movement {
 public:
  Movement() = default;
  virtual ~Movement() = default;
  Movement(const Movement&) = delete;
  Movement& operator=(const Movement&) = delete;
  Movement(Movement&&) = delete;
  Movement& operator=(Movement&&) = delete;

  /// Every control at `time`, which may be any: before, within or after the utterance. `values` has
  /// one place for each control. Several threads may ask at once; nothing is allocated.
  virtual void at(Milliseconds time, std::span<double> values) const = 0;
};

}  // namespace bimodal::synth
