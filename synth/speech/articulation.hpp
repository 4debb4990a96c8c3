#pragma once

#include <memory>
#include <span>
#include <vector>

#include "stimuli/timeline/segment.hpp"
#include "stimuli/timeline/utterance.hpp"
#include "synth/speech/account.hpp"
#include "synth/speech/control.hpp"
#include "synth/speech/movement.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::synth {

/// The movement of the face for one utterance: every speech control as a function of time, by the
/// dominance model of Cohen & Massaro (1993) or a rival account of coarticulation. Values may lie
/// beyond a control's range (a closure target beyond contact); the face clamps them.
class Articulation {
 public:
  Articulation(const Utterance& utterance,
               const SegmentTable& table,
               Account account = Account::Dominance);

  /// Of segments in order, some of which may be ambiguous; the first starts at 0 or later.
  Articulation(std::span<const TimedSegment> utterance,
               const SegmentTable& table,
               Account account = Account::Dominance);

  /// Every control at `time` since the start of the utterance; defined for all times. The controls
  /// that speech does not set are neutral.
  [[nodiscard]] Pose at(Milliseconds time) const;

  /// Poses at the instants 0, 1/rate, 2/rate ... that lie before the utterance's end.
  [[nodiscard]] std::vector<Pose> sample(Hertz rate) const;

  [[nodiscard]] Milliseconds end() const { return end_; }

 private:
  std::shared_ptr<const Movement> movement_;  ///< of the speech controls
  Milliseconds end_{};
};

}  // namespace bimodal::synth
