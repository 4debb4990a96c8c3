#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "synth/speech/knot_path.hpp"
#include "synth/speech/rival_movements.hpp"

namespace bimodal::synth {

namespace {

/// A vowel or rest that was found some transitions away.
struct Found {
  std::size_t index;
  std::size_t transitions;
  int rank;
};

class LookAhead final : public Movement {
 public:
  LookAhead(std::span<const Claimant> claimants, const ControlClaims& claims) {
    const auto yields = yieldings(claimants);
    for (const auto& asked : claims) paths_.push_back(path_of(asked, yields));
  }

  void at(Milliseconds time, std::span<double> values) const override {
    for (std::size_t control = 0; control < paths_.size(); ++control) {
      const auto& [path, influences] = paths_[control];
      const auto [knot, along] = path.place(time.count());
      const auto next = along > 0 ? knot + 1 : knot;
      const double line = std::lerp(path.knots[knot].value, path.knots[next].value, along);
      const double gamma = std::lerp(influences[knot].gamma, influences[next].gamma, along);
      const double pull = std::lerp(influences[knot].pull, influences[next].pull, along);
      values[control] = (1 - gamma) * line + pull;
    }
  }

 private:
  struct Influence {
    double gamma;
    double pull;  ///< gamma times the target that is yielded to
  };

  struct Path {
    KnotPath path;
    std::vector<Influence> influences;  ///< one per knot
  };

  static Path path_of(const std::vector<Claim>& asked, const std::vector<Yielding>& yields) {
    std::vector<const Claim*> in_time;
    for (const auto& claim : asked) in_time.push_back(&claim);
    std::ranges::stable_sort(in_time, {}, [](const Claim* claim) { return claim->peak; });
    Path made;
    for (const auto* claim : in_time) {
      made.path.knots.push_back({.time_ms = claim->peak.count(), .value = claim->target});
      const auto& yielding = yields[claim->segment];
      const auto other = std::ranges::lower_bound(asked, yielding.to, {}, &Claim::segment);
      const bool is_claimed = other != asked.end() && other->segment == yielding.to;
      const double gamma = is_claimed ? yielding.gamma : 0;
      made.influences.push_back({.gamma = gamma, .pull = gamma > 0 ? gamma * other->target : 0});
    }
    return made;
  }

  std::vector<Path> paths_;
};

}  // namespace

std::vector<Yielding> yieldings(std::span<const Claimant> claimants) {
  std::vector<Yielding> yields(claimants.size());
  for (std::size_t i = 0; i < claimants.size(); ++i) {
    if (claimants[i].is_nucleus) continue;
    std::optional<Found> ahead;
    std::optional<Found> behind;
    for (std::size_t p = 1; p <= kLookedOver; ++p) {
      if (!ahead && i + p < claimants.size() && claimants[i + p].is_nucleus) {
        ahead = {.index = i + p, .transitions = p, .rank = claimants[i + p].rank};
      }
      if (!behind && p <= i && claimants[i - p].is_nucleus) {
        behind = {.index = i - p, .transitions = p, .rank = claimants[i - p].rank};
      }
    }
    const bool is_ahead = ahead && (!behind || ahead->rank < behind->rank);
    const auto& stronger = is_ahead ? ahead : behind;
    if (!stronger || stronger->rank >= claimants[i].rank) continue;
    const auto transitions = static_cast<double>(stronger->transitions);
    yields[i] = {.gamma = kYielding * std::exp(-transitions / 5), .to = stronger->index};
  }
  return yields;
}

std::unique_ptr<const Movement> look_ahead(std::span<const Claimant> claimants,
                                           const ControlClaims& claims) {
  return std::make_unique<LookAhead>(claimants, claims);
}

}  // namespace bimodal::synth
