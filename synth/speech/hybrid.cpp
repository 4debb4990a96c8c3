#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "synth/speech/knot_path.hpp"
#include "synth/speech/rival_movements.hpp"

namespace bimodal::synth {

namespace {

class Hybrid final : public Movement {
 public:
  Hybrid(std::span<const Claimant> claimants, const ControlClaims& claims) {
    for (const auto& asked : claims) tracks_.push_back(track_of(claimants, asked));
  }

  void at(Milliseconds time, std::span<double> values) const override {
    for (std::size_t control = 0; control < tracks_.size(); ++control) {
      const auto& track = tracks_[control];
      const auto [knot, along] = track.path.place(time.count());
      const double from = track.path.knots[knot].value;
      const bool is_fast = track.is_fast[knot];
      const double way = is_fast ? 0.5 - 0.5 * std::cos(std::numbers::pi * along) : along;
      values[control] = along > 0 ? std::lerp(from, track.path.knots[knot + 1].value, way) : from;
    }
  }

 private:
  struct Track {
    KnotPath path;
    std::vector<bool> is_fast;  ///< the phase that begins at each knot

    void add(double time_ms, double value, bool fast_from_here) {
      path.knots.push_back({.time_ms = time_ms, .value = value});
      is_fast.push_back(fast_from_here);
    }
  };

  static Track track_of(std::span<const Claimant> claimants, const std::vector<Claim>& asked) {
    const double threshold = claiming_threshold(asked);
    Track track;
    const Claim* last = nullptr;
    for (const auto& claim : asked) {
      if (claim.dominance.alpha <= threshold) continue;
      if (last != nullptr) add_way(track, claimants, *last, claim);
      last = &claim;
    }
    const auto& claimant = claimants[last->segment];
    track.add(claimant.end.count(), last->target, false);
    return track;
  }

  /// From the end of one claimant to the onset of the next. Where they are closer than the fast
  /// phase is long, that phase begins as early as the middle of the first one, but not earlier.
  static void add_way(Track& track,
                      std::span<const Claimant> claimants,
                      const Claim& from,
                      const Claim& to) {
    const auto& left = claimants[from.segment];
    const double onset = claimants[to.segment].start.count();
    const double left_end = left.end.count();
    const double middle = (left.start.count() + left_end) / 2;
    const double theta = to.dominance.theta_before;
    const double fast = theta > 0 ? onset - kGestureExtent / theta : middle;
    if (fast > left_end) {
      track.add(left_end, from.target, false);
      track.add(fast, std::lerp(from.target, to.target, kSlowPart), true);
    } else {
      track.add(std::max(fast, middle), from.target, true);
    }
    track.add(onset, to.target, false);
  }

  std::vector<Track> tracks_;
};

}  // namespace

std::unique_ptr<const Movement> hybrid(std::span<const Claimant> claimants,
                                       const ControlClaims& claims) {
  return std::make_unique<Hybrid>(claimants, claims);
}

}  // namespace bimodal::synth
