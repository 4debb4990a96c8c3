#include "stimuli/alignment/word_graph.hpp"

#include <algorithm>

namespace bimodal {

namespace {

constexpr std::size_t kMostFramesMoved = 100;

PlaceInWord place_in_word(bool first, bool last) {
  if (first) return last ? PlaceInWord::Alone : PlaceInWord::First;
  return last ? PlaceInWord::Last : PlaceInWord::Inside;
}

}  // namespace

std::vector<PhoneUnit> context_free_units(const AcousticModel& model,
                                          std::size_t first_frame,
                                          std::size_t end_frame) {
  std::vector<PhoneUnit> units;
  for (const Phone phone : all_phones()) {
    units.push_back(model.unit(phone));
    units.back().first_frame = first_frame;
    units.back().end_frame = modelled(phone) == phone ? end_frame : first_frame;
  }
  return units;
}

std::vector<PhoneUnit> units_of(const WordGraph& graph, const AcousticModel& model) {
  auto units = context_free_units(model, 0, 0);
  for (const auto& node : graph.nodes) units[node.unit].end_frame = kAllFrames;
  return units;
}

PhoneNode context_free_node(Phone phone) {
  return {.phone = phone, .unit = static_cast<std::size_t>(modelled(phone)), .before = {}};
}

WordGraph graph_of(std::span<const SpokenWord> words) {
  WordGraph graph;
  const auto add = [&](Phone phone,
                       std::vector<std::size_t> before,
                       std::optional<std::size_t> word = std::nullopt) {
    graph.nodes.push_back(context_free_node(phone));
    graph.nodes.back().before = std::move(before);
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

Chain chain_of(std::span<const PathStep> path, const WordGraph& graph, const AcousticModel& model) {
  Chain chain;
  const auto phone = [&](std::size_t i) { return graph.nodes[path[i].node].phone; };
  const auto word = [&](std::size_t i) { return graph.word[path[i].node]; };
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool first = i == 0 || word(i - 1) != word(i);
    const bool last = i + 1 == path.size() || word(i + 1) != word(i);
    const Phone left = i == 0 ? Phone::Rest : phone(i - 1);
    const Phone right = i + 1 == path.size() ? Phone::Rest : phone(i + 1);
    // Triphones before rest have learned some of the rest: with them, words end 30 ms too late.
    chain.units.push_back(right == Phone::Rest
                              ? model.unit(phone(i))
                              : model.unit(phone(i), left, right, place_in_word(first, last)));
    auto& unit = chain.units.back();
    const auto [node, begin, frames] = path[i];
    unit.first_frame = begin - std::min(begin, kMostFramesMoved);
    unit.end_frame = begin + frames + kMostFramesMoved;
    chain.graph.nodes.push_back({.phone = phone(i), .unit = i, .before = {}});
    if (i > 0) chain.graph.nodes.back().before = {i - 1};
    chain.graph.word.push_back(word(i));
  }
  return chain;
}

}  // namespace bimodal
