#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "stimuli/timeline/utterance.hpp"
#include "synth/speech/control.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::synth {

/// The movement of the face for one utterance: every speech control as a function of time, by the
/// dominance model of Cohen & Massaro (1993, equations 1-6). Values may lie beyond a control's
/// range (a closure target beyond contact); the face clamps them.
class Articulation {
 public:
  Articulation(const Utterance& utterance, const SegmentTable& table);

  /// Every control at `time` since the start of the utterance; defined for all times. The controls
  /// that speech does not set are neutral.
  [[nodiscard]] Pose at(Duration time) const;

  /// Poses at the instants 0, 1/rate, 2/rate ... that lie before the utterance's end.
  [[nodiscard]] std::vector<Pose> sample(Hertz rate) const;

 private:
  std::array<std::vector<Claim>, kSpeechControlCount> claims_;
  Duration end_{};
};

}  // namespace bimodal::synth
