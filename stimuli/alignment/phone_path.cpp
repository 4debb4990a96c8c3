#include "stimuli/alignment/phone_path.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>

namespace bimodal {

namespace {

constexpr float kNever = -std::numeric_limits<float>::infinity();

/// Log likelihood of the best path that has come to each state of a phone.
using Reached = std::array<float, kStates>;
constexpr Reached kNowhere{kNever, kNever, kNever};

float leaving(const Reached& reached, const Transitions& transitions) {
  return reached.back() + transitions.leave.back();
}

/// How a state of a node was reached: 0 from itself, else from the state before it or, into the
/// first state, from the end of the node `before[origin - 1]`.
using Origin = std::uint16_t;
using Origins = std::array<Origin, kStates>;

/// One frame's work on a node that is entered with `entry` from `origin`.
Origins step(Reached& reached,
             const Transitions& transitions,
             const std::array<float, kStates>& score,
             float entry,
             Origin origin) {
  Origins origins{};
  for (std::size_t state = kStates; state-- > 0;) {
    const float stays = reached.at(state) + transitions.stay.at(state);
    const float comes =
        state == 0 ? entry : reached.at(state - 1) + transitions.leave.at(state - 1);
    origins.at(state) = comes > stays ? (state == 0 ? origin : Origin{1}) : Origin{0};
    reached.at(state) = std::max(comes, stays) + score.at(state);
  }
  return origins;
}

/// The search's front: the nodes that may be on the best path at one frame.
struct Front {
  std::vector<Reached> reached;
  std::size_t low = 0;   ///< nodes before this one are nowhere
  std::size_t high = 1;  ///< and so are this one and all after it
};

/// Moves a front on, frame by frame.
class Search {
 public:
  /// Nodes whose log likelihood is that much below the best one's are given up.
  Search(const PhoneGraph& graph, const UnitScores& scores, const AcousticModel& model, float beam)
      : graph_{graph}, scores_{scores}, model_{model}, beam_{beam} {
    for (std::size_t node = 0; node < graph.size(); ++node) {
      for (const auto before : graph[node].before) reach_ = std::max(reach_, node - before);
    }
  }

  [[nodiscard]] Front begin() const {
    Front front{.reached = std::vector<Reached>(graph_.size(), kNowhere)};
    front.reached.front().front() = scores_.at(0, graph_.front().unit).front();
    return front;
  }

  /// From frame - 1 to frame. `origins` has an entry a node, or is empty if they are not wanted.
  void advance(Front& front, std::size_t frame, std::span<Origins> origins) const {
    auto& reached = front.reached;
    front.high = std::min(graph_.size(), front.high + reach_);
    float best = kNever;
    // Backwards, so that what stands before a node is still as it was one frame ago.
    for (std::size_t node = front.high; node-- > front.low;) {
      const auto& [phone, unit, before] = graph_[node];
      float entry = kNever;
      Origin origin = 0;
      for (std::size_t i = 0; i < before.size(); ++i) {
        const float left = leaving(reached[before[i]], model_.transitions(graph_[before[i]].phone));
        if (left <= entry) continue;
        entry = left;
        origin = static_cast<Origin>(i + 1);
      }
      const auto found =
          step(reached[node], model_.transitions(phone), scores_.at(frame, unit), entry, origin);
      if (!origins.empty()) origins[node] = found;
      best = std::max(best, std::ranges::max(reached[node]));
    }
    give_up_below(front, best - beam_);
  }

 private:
  static void give_up_below(Front& front, float limit) {
    const auto hopeless = [&](std::size_t node) {
      return !(std::ranges::max(front.reached[node]) > limit);
    };
    while (front.low + 1 < front.high && hopeless(front.low)) front.reached[front.low++] = kNowhere;
    while (front.high > front.low + 1 && hopeless(front.high - 1)) {
      front.reached[--front.high] = kNowhere;
    }
  }

  const PhoneGraph& graph_;
  const UnitScores& scores_;
  const AcousticModel& model_;
  float beam_;
  std::size_t reach_ = 0;  ///< how far at most a node stands behind one before it
};

/// Where the path is, going backwards in time.
struct Trace {
  std::size_t node = 0;
  std::size_t state = kStates - 1;
  std::vector<PathStep> steps;  ///< the last one first

  void go_back(const PhoneGraph& graph, std::span<const Origins> origins, std::size_t frame) {
    ++steps.back().frames;
    const auto origin = origins[node].at(state);
    if (origin == 0) return;
    if (state > 0) {
      --state;
      return;
    }
    steps.back().first_frame = frame;
    node = graph[node].before[origin - 1U];
    state = kStates - 1;
    steps.push_back({.node = node});
  }
};

std::optional<std::vector<PathStep>> best_path_within(float beam,
                                                      const PhoneGraph& graph,
                                                      const UnitScores& scores,
                                                      const AcousticModel& model) {
  // The front is kept at the beginning of every block only; going back, each block is done again
  // with its origins.
  constexpr std::size_t kBlock = 256;
  const Search search{graph, scores, model, beam};
  std::vector<Front> kept;
  auto front = search.begin();
  for (std::size_t frame = 1; frame < scores.frames(); ++frame) {
    if (frame % kBlock == 1) kept.push_back(front);
    search.advance(front, frame, {});
  }
  if (front.reached.back().back() == kNever) return std::nullopt;

  Trace trace{.node = graph.size() - 1, .state = kStates - 1, .steps = {}};
  trace.steps.push_back({.node = trace.node});
  std::vector<Origins> origins(kBlock * graph.size());
  for (std::size_t block = kept.size(); block-- > 0;) {
    const std::size_t first = block * kBlock + 1;
    const std::size_t end = std::min(first + kBlock, scores.frames());
    const auto of = [&](std::size_t frame) {
      return std::span{origins}.subspan((frame - first) * graph.size(), graph.size());
    };
    for (std::size_t frame = first; frame < end; ++frame) {
      search.advance(kept[block], frame, of(frame));
    }
    for (std::size_t frame = end; frame-- > first;) trace.go_back(graph, of(frame), frame);
    kept.pop_back();
  }
  ++trace.steps.back().frames;  // frame 0
  std::ranges::reverse(trace.steps);
  return trace.steps;
}

}  // namespace

std::optional<std::vector<PathStep>> best_path(const PhoneGraph& graph,
                                               const UnitScores& scores,
                                               const AcousticModel& model) {
  constexpr std::size_t kManyFrames = 3000;
  constexpr float kBeam = 3000.0F;
  constexpr float kEverything = std::numeric_limits<float>::max();
  if (graph.empty() || scores.frames() == 0) return std::nullopt;
  if (scores.frames() > kManyFrames) {
    if (auto path = best_path_within(kBeam, graph, scores, model)) return path;
  }
  return best_path_within(kEverything, graph, scores, model);
}

double phone_likelihood(const PhoneNode& node,
                        std::size_t first,
                        std::size_t frames,
                        const UnitScores& scores,
                        const AcousticModel& model) {
  const auto& transitions = model.transitions(node.phone);
  auto reached = kNowhere;
  float entry = 0.0F;
  for (std::size_t frame = first; frame < first + frames; ++frame) {
    step(reached, transitions, scores.at(frame, node.unit), entry, 1);
    entry = kNever;
  }
  return static_cast<double>(leaving(reached, transitions));
}

double free_likelihood(std::span<const PhoneNode> phones,
                       std::size_t first,
                       std::size_t frames,
                       const UnitScores& scores,
                       const AcousticModel& model) {
  std::vector<Reached> reached(phones.size(), kNowhere);
  float entry = 0.0F;
  for (std::size_t frame = first; frame < first + frames; ++frame) {
    float next = kNever;
    for (std::size_t i = 0; i < phones.size(); ++i) {
      const auto& transitions = model.transitions(phones[i].phone);
      step(reached[i], transitions, scores.at(frame, phones[i].unit), entry, 1);
      next = std::max(next, leaving(reached[i], transitions));
    }
    entry = next;
  }
  return static_cast<double>(entry);
}

}  // namespace bimodal
