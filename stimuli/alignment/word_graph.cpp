#include "stimuli/alignment/word_graph.hpp"

namespace bimodal {

WordGraph graph_of(std::span<const SpokenWord> words) {
  WordGraph graph;
  const auto add = [&](Phone phone,
                       std::vector<std::size_t> before,
                       std::optional<std::size_t> word = std::nullopt) {
    graph.nodes.push_back({phone, std::move(before)});
    graph.word.push_back(word);
    return graph.nodes.size() - 1;
  };
  std::vector<std::size_t> before{add(Phone::Rest, {})};
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::vector<std::size_t> ends;
    for (const auto& phones : words[i].pronunciations) {
      auto preceding = before;
      for (const Phone phone : phones) preceding = {add(phone, preceding, i)};
      ends.push_back(preceding.front());
    }
    before = ends;
    before.push_back(add(Phone::Rest, ends));
  }
  return graph;
}

}  // namespace bimodal
