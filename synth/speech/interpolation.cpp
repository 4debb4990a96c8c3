#include <algorithm>
#include <cmath>
#include <span>

#include "synth/speech/knot_path.hpp"
#include "synth/speech/rival_movements.hpp"

namespace bimodal::synth {

namespace {

class Interpolation final : public Movement {
 public:
  explicit Interpolation(const ControlClaims& claims) {
    for (const auto& asked : claims) {
      auto& knots = paths_.emplace_back().knots;
      for (const auto& claim : asked) {
        knots.push_back({.time_ms = claim.peak.count(), .value = claim.target});
      }
      std::ranges::stable_sort(knots, {}, &KnotPath::Knot::time_ms);
    }
  }

  void at(Milliseconds time, std::span<double> values) const override {
    for (std::size_t control = 0; control < paths_.size(); ++control) {
      const auto& knots = paths_[control].knots;
      const auto [knot, along] = paths_[control].place(time.count());
      const double from = knots[knot].value;
      values[control] = along > 0 ? std::lerp(from, knots[knot + 1].value, along) : from;
    }
  }

 private:
  std::vector<KnotPath> paths_;
};

}  // namespace

std::unique_ptr<const Movement> interpolation(const ControlClaims& claims) {
  return std::make_unique<Interpolation>(claims);
}

}  // namespace bimodal::synth
