#pragma once

#include <optional>
#include <span>
#include <vector>

#include "stimuli/alignment/acoustic_model.hpp"

namespace bimodal {

/// One phone that may be heard, and what may come just before it.
struct PhoneNode {
  Phone phone = Phone::Rest;
  std::size_t unit = 0;             ///< its column of scores
  std::vector<std::size_t> before;  ///< indices of nodes that stand before this one
};

/// Which sequences of phones may be heard: from the first node to the last one, each node after all
/// that may come before it.
using PhoneGraph = std::vector<PhoneNode>;

/// A node that is heard, and when.
struct PathStep {
  std::size_t node = 0;
  std::size_t first_frame = 0;
  std::size_t frames = 0;  ///< at least kStates
};

/// The likeliest path through the graph that takes up all frames (Viterbi 1967); absent if there
/// are fewer frames than the shortest path needs. In more than 3000 frames, what has fallen behind
/// the best by 3000 (natural logarithm, some ten seconds in the wrong place) is given up, unless
/// nothing else comes to the end. Memory grows with the nodes times the square root of the frames.
[[nodiscard]] std::optional<std::vector<PathStep>> best_path(const PhoneGraph& graph,
                                                             const UnitScores& scores,
                                                             const AcousticModel& model);

/// Log likelihood of the frames from `first` as one phone; minus infinity if they are too few.
[[nodiscard]] double phone_likelihood(const PhoneNode& node,
                                      std::size_t first,
                                      std::size_t frames,
                                      const UnitScores& scores,
                                      const AcousticModel& model);

/// Log likelihood of the frames from `first` as the likeliest of all sequences of the phones.
[[nodiscard]] double free_likelihood(std::span<const PhoneNode> phones,
                                     std::size_t first,
                                     std::size_t frames,
                                     const UnitScores& scores,
                                     const AcousticModel& model);

}  // namespace bimodal
