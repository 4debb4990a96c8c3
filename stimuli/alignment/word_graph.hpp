#pragma once

#include <optional>
#include <span>
#include <vector>

#include "stimuli/alignment/aligner.hpp"
#include "stimuli/alignment/phone_path.hpp"

namespace bimodal {

/// Which phones may be heard where words are said.
struct WordGraph {
  PhoneGraph nodes;
  std::vector<std::optional<std::size_t>> word;  ///< of each node; absent: rest
};

/// The units of all phones in no particular context, in order of Phone, wanted in some frames only;
/// none is wanted for a phone that is modelled as another one.
[[nodiscard]] std::vector<PhoneUnit> context_free_units(const AcousticModel& model,
                                                        std::size_t first_frame,
                                                        std::size_t end_frame);

/// The same for the phones of a graph and all frames; no others are wanted.
[[nodiscard]] std::vector<PhoneUnit> units_of(const WordGraph& graph, const AcousticModel& model);

/// A node of one of those units, with nothing before it.
[[nodiscard]] PhoneNode context_free_node(Phone phone);

/// The words in order, each by any of its pronunciations, of context-free nodes: rest before and
/// after, and wherever two words meet rest or none.
[[nodiscard]] WordGraph graph_of(std::span<const SpokenWord> words);

/// A path through a graph as a graph of its own, to be searched again with what is now known: the
/// phones' contexts. A node's unit is the one with its own index.
struct Chain {
  WordGraph graph;
  std::vector<PhoneUnit> units;  ///< within a second of where the path has the phone
};

[[nodiscard]] Chain chain_of(std::span<const PathStep> path,
                             const WordGraph& graph,
                             const AcousticModel& model);

}  // namespace bimodal
