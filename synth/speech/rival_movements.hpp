#pragma once

#include <memory>
#include <span>
#include <vector>

#include "synth/speech/claimant.hpp"
#include "synth/speech/movement.hpp"

namespace bimodal::synth {

/// A segment claims a control only with an alpha above this part of the greatest alpha that any
/// segment of the utterance has on it; others take what their neighbours have. For accounts that
/// know no degrees: time-locked and hybrid.
inline constexpr double kClaimingAlpha = 0.1;

/// The alpha above which a segment claims the control of these claims.
[[nodiscard]] double claiming_threshold(const std::vector<Claim>& claims);

/// A gesture of the time-locked account takes this long, over theta in 1/ms, from nothing to full
/// (a raised cosine). Then it rises from 10 to 90 % in 2.2 / theta, as two equal dominances that
/// cross do.
inline constexpr double kGestureExtent = 3.7;

/// The slow phase of the hybrid account covers this part of the way (chosen by us; Perkell's
/// figures give no number).
inline constexpr double kSlowPart = 0.25;

/// Kapoor, Goyal & Kalra (2000, section 4.2): how much a consonant yields to a vowel next to it, K
/// exp(-p / 5) at p transitions, and how far it looks.
inline constexpr double kYielding = 0.5;
inline constexpr std::size_t kLookedOver = 5;

/// No coarticulation: from peak to peak each control moves on a straight line; before the first and
/// after the last it rests.
[[nodiscard]] std::unique_ptr<const Movement> interpolation(const ControlClaims& claims);

/// What a segment yields to which other one under look-ahead.
struct Yielding {
  double gamma = 0;    ///< 0: keeps its own target; 1: would take the other's
  std::size_t to = 0;  ///< index of that segment; meaningless where gamma is 0
};

/// Kapoor, Goyal & Kalra (2000, section 4.2): a consonant yields to the less deformable of the
/// nearest vowels (or rests) ahead and behind, if that is less deformable than itself; of two alike
/// to the one behind. The paper's "R_f > R_b" compares the order of dominance, the opposite of the
/// rank's number, as its own example shows. One per segment.
[[nodiscard]] std::vector<Yielding> yieldings(std::span<const Claimant> claimants);

/// Straight lines between targets of which each yields as yieldings() says, by the paper's
/// barycentric rule: (1 - gamma) of the line, gamma of the target yielded to, gamma itself moving
/// on a straight line.
[[nodiscard]] std::unique_ptr<const Movement> look_ahead(std::span<const Claimant> claimants,
                                                         const ControlClaims& claims);

/// Coproduction: the gesture of each claimant rises over kGestureExtent / theta_before before the
/// segment's acoustic onset, stays until its end and falls over kGestureExtent / theta_after; where
/// gestures overlap, a control is their mean, weighted by alpha. So a gesture begins a fixed time
/// before its sound, whatever stands there. What no gesture claims is as the segments without claim
/// have it, and rest, which makes no gesture, on straight lines between their middles.
[[nodiscard]] std::unique_ptr<const Movement> time_locked(std::span<const Claimant> claimants,
                                                          const ControlClaims& claims);

/// Two phases: a control that the last claimant left begins to move at that claimant's end, evenly
/// and for kSlowPart of the way, until the next claimant's time-locked phase begins,
/// kGestureExtent / theta_before ahead of its onset; that one (a raised cosine) ends at the onset.
[[nodiscard]] std::unique_ptr<const Movement> hybrid(std::span<const Claimant> claimants,
                                                     const ControlClaims& claims);

}  // namespace bimodal::synth
