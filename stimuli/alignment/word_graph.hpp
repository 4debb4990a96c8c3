#pragma once

#include <span>
#include <vector>

#include "stimuli/alignment/aligner.hpp"
#include "stimuli/alignment/phone_path.hpp"

namespace bimodal {

/// The words in order, each by any of its pronunciations: rest before and after, and wherever two
/// words meet rest or none.
struct WordGraph {
  PhoneGraph nodes;
  /// Of each node, which phone of which word it is; `word` of a rest is absent.
  std::vector<std::optional<std::size_t>> word;
};

[[nodiscard]] WordGraph graph_of(std::span<const SpokenWord> words);

}  // namespace bimodal
