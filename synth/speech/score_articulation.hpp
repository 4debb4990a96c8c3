#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "synth/speech/account.hpp"
#include "synth/speech/control.hpp"
#include "synth/speech/score.hpp"

namespace bimodal::synth {

/// The movement of the face for a score: as Articulation, whose utterances have no controls of
/// their own. Controls that the score does not have are neutral, and those of it that the face does
/// not have are passed over.
class ScoreArticulation {
 public:
  explicit ScoreArticulation(const ScoreClaims& claims, Account account = Account::Dominance);

  /// Every control at `time`. One caller at a time: the work space is shared.
  [[nodiscard]] Pose at(Milliseconds time);

 private:
  std::unique_ptr<const Movement> movement_;
  std::vector<std::optional<Control>> controls_;
  std::vector<double> values_;
};

}  // namespace bimodal::synth
