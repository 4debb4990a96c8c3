#pragma once

#include <span>
#include <vector>

#include "stimuli/timeline/segment.hpp"

namespace bimodal::synth {

/// What accounts of coarticulation other than dominance know of a segment.
struct Claimant {
  Milliseconds start{};  ///< acoustic onset
  Milliseconds end{};
  int rank = 10;            ///< deformability, 1 (the least) to 10
  bool is_nucleus = false;  ///< vowel or rest: does not give way, others give way to it
  bool is_rest = false;     ///< makes no gesture
};

/// The deformability of a phone's lip shape, 1 (the least) to 10: figure 4 of Kapoor, A., Goyal, A.
/// & Kalra, P. (2000), "Modeling co-articulation in text-to-audio visual speech", after Pelachaud
/// (1991).
/// Its sixteen visemes are given to this project's phones; WH stands with W, ER with AH and AX.
[[nodiscard]] int deformability(Phone phone);

/// An ambiguous segment is ranked as the nearer of its two phones.
[[nodiscard]] std::vector<Claimant> claimants_of(std::span<const TimedSegment> segments);

}  // namespace bimodal::synth
