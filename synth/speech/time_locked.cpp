#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "synth/speech/knot_path.hpp"
#include "synth/speech/rival_movements.hpp"

namespace bimodal::synth {

namespace {

/// From 0 to 1 on a raised cosine while `along` goes from 0 to 1.
double rise(double along) {
  return 0.5 - 0.5 * std::cos(std::numbers::pi * std::clamp(along, 0.0, 1.0));
}

struct Gesture {
  double begin;  ///< ms, of the rise
  double full;   ///< ms
  double fall;   ///< ms, begin of the fall
  double end;    ///< ms
  double alpha;
  double target;

  [[nodiscard]] double weight(double time_ms) const {
    if (time_ms < full && !std::isinf(begin)) return rise((time_ms - begin) / (full - begin));
    if (time_ms <= fall || std::isinf(end)) return 1;
    return rise((end - time_ms) / (end - fall));
  }
};

/// How long a gesture of rate `theta` takes to rise or fall; for ever where theta is 0.
double extent(double theta) {
  return theta > 0 ? kGestureExtent / theta : std::numeric_limits<double>::infinity();
}

class TimeLocked final : public Movement {
 public:
  TimeLocked(std::span<const Claimant> claimants, const ControlClaims& claims) {
    for (const auto& asked : claims) tracks_.push_back(track_of(claimants, asked));
  }

  void at(Milliseconds time, std::span<double> values) const override {
    for (std::size_t control = 0; control < tracks_.size(); ++control) {
      values[control] = value(tracks_[control], time.count());
    }
  }

 private:
  struct Track {
    std::vector<Gesture> gestures;  ///< of the claimants, by begin
    std::vector<double> ends;       ///< the latest of this gesture's and all before
    KnotPath others;                ///< what is left to itself where no gesture is under way
    double lowest = 0;
    double highest = 0;
  };

  static Track track_of(std::span<const Claimant> claimants, const std::vector<Claim>& asked) {
    Track track;
    const double threshold = claiming_threshold(asked);
    KnotPath all;
    for (const auto& claim : asked) {
      const auto& claimant = claimants[claim.segment];
      const KnotPath::Knot knot{.time_ms = claimant.start.count() / 2 + claimant.end.count() / 2,
                                .value = claim.target};
      all.knots.push_back(knot);
      if (claimant.is_rest || claim.dominance.alpha <= threshold) {
        track.others.knots.push_back(knot);
        continue;
      }
      track.gestures.push_back(
          {.begin = claimant.start.count() - extent(claim.dominance.theta_before),
           .full = claimant.start.count(),
           .fall = claimant.end.count(),
           .end = claimant.end.count() + extent(claim.dominance.theta_after),
           .alpha = claim.dominance.alpha,
           .target = claim.target});
    }
    if (track.others.knots.empty()) track.others = std::move(all);
    std::ranges::stable_sort(track.gestures, {}, &Gesture::begin);
    double latest = -std::numeric_limits<double>::infinity();
    for (const auto& gesture : track.gestures) {
      track.ends.push_back(latest = std::max(latest, gesture.end));
    }
    const auto [lowest, highest] = std::ranges::minmax(asked, {}, &Claim::target);
    track.lowest = lowest.target;
    track.highest = highest.target;
    return track;
  }

  static double value(const Track& track, double time_ms) {
    const auto& gestures = track.gestures;
    const auto after = std::ranges::upper_bound(gestures, time_ms, {}, &Gesture::begin);
    double activity = 0;
    double total = 0;
    double sum = 0;
    for (auto i = static_cast<std::size_t>(after - gestures.begin());
         i-- > 0 && track.ends[i] > time_ms;) {
      if (gestures[i].end <= time_ms) continue;
      const double weight = gestures[i].weight(time_ms);
      activity += weight;
      total += gestures[i].alpha * weight;
      sum += gestures[i].alpha * weight * gestures[i].target;
    }
    const double left = left_to_itself(track.others, time_ms);
    if (total <= 0) return left;
    const double moved = std::lerp(left, sum / total, std::min(1.0, activity));
    return std::clamp(moved, track.lowest, track.highest);
  }

  static double left_to_itself(const KnotPath& others, double time_ms) {
    const auto [knot, along] = others.place(time_ms);
    const double from = others.knots[knot].value;
    return along > 0 ? std::lerp(from, others.knots[knot + 1].value, along) : from;
  }

  std::vector<Track> tracks_;
};

}  // namespace

std::unique_ptr<const Movement> time_locked(std::span<const Claimant> claimants,
                                            const ControlClaims& claims) {
  return std::make_unique<TimeLocked>(claimants, claims);
}

}  // namespace bimodal::synth
