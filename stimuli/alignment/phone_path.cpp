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

/// The search's front, which moves on frame by frame.
class Front {
 public:
  Front(const PhoneGraph& graph, const UnitScores& scores, const AcousticModel& model)
      : graph_{graph}, scores_{scores}, model_{model} {}

  [[nodiscard]] std::vector<Reached> begin() const {
    std::vector<Reached> reached(graph_.size(), kNowhere);
    reached.front().front() = scores_.at(0, graph_.front().unit).front();
    return reached;
  }

  /// From frame - 1 to frame. `origins` has an entry a node, or is empty if they are not wanted.
  void advance(std::vector<Reached>& reached, std::size_t frame, std::span<Origins> origins) const {
    // Backwards, so that what stands before a node is still as it was one frame ago.
    for (std::size_t node = graph_.size(); node-- > 0;) {
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
    }
  }

 private:
  const PhoneGraph& graph_;
  const UnitScores& scores_;
  const AcousticModel& model_;
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

}  // namespace

std::optional<std::vector<PathStep>> best_path(const PhoneGraph& graph,
                                               const UnitScores& scores,
                                               const AcousticModel& model) {
  // The front is kept at the beginning of every block only; going back, each block is done again
  // with its origins.
  constexpr std::size_t kBlock = 256;
  if (graph.empty() || scores.frames() == 0) return std::nullopt;
  const Front front{graph, scores, model};
  std::vector<std::vector<Reached>> kept;
  auto reached = front.begin();
  for (std::size_t frame = 1; frame < scores.frames(); ++frame) {
    if (frame % kBlock == 1) kept.push_back(reached);
    front.advance(reached, frame, {});
  }
  if (reached.back().back() == kNever) return std::nullopt;

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
      front.advance(kept[block], frame, of(frame));
    }
    for (std::size_t frame = end; frame-- > first;) trace.go_back(graph, of(frame), frame);
    kept.pop_back();
  }
  ++trace.steps.back().frames;  // frame 0
  std::ranges::reverse(trace.steps);
  return trace.steps;
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
