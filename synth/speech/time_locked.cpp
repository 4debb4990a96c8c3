#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

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
    if (time_ms < full && !std::isinf(begin)) {
      return alpha * rise((time_ms - begin) / (full - begin));
    }
    if (time_ms <= fall || std::isinf(end)) return alpha;
    return alpha * rise((end - time_ms) / (end - fall));
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
    std::vector<Gesture> gestures;  ///< by begin
    std::vector<double> ends;       ///< the latest of this gesture's and all before
    double lowest = 0;
    double highest = 0;
  };

  static Track track_of(std::span<const Claimant> claimants, const std::vector<Claim>& asked) {
    Track track;
    for (const auto& claim : asked) {
      const auto& claimant = claimants[claim.segment];
      const double lead = extent(claim.dominance.theta_before);
      const double lag = extent(claim.dominance.theta_after);
      track.gestures.push_back({.begin = claimant.start.count() - lead,
                                .full = claimant.start.count(),
                                .fall = claimant.end.count(),
                                .end = claimant.end.count() + lag,
                                .alpha = claim.dominance.alpha,
                                .target = claim.target});
    }
    std::ranges::stable_sort(track.gestures, {}, &Gesture::begin);
    double latest = -std::numeric_limits<double>::infinity();
    for (const auto& gesture : track.gestures) {
      track.ends.push_back(latest = std::max(latest, gesture.end));
    }
    const auto [lowest, highest] = std::ranges::minmax(track.gestures, {}, &Gesture::target);
    track.lowest = lowest.target;
    track.highest = highest.target;
    return track;
  }

  static double value(const Track& track, double time_ms) {
    const auto& gestures = track.gestures;
    const auto after = std::ranges::upper_bound(gestures, time_ms, {}, &Gesture::begin);
    const auto begun = static_cast<std::size_t>(after - gestures.begin());
    double sum = 0;
    double total = 0;
    for (std::size_t i = begun; i-- > 0 && track.ends[i] > time_ms;) {
      if (gestures[i].end <= time_ms) continue;
      const double weight = gestures[i].weight(time_ms);
      sum += weight * gestures[i].target;
      total += weight;
    }
    if (total > 0) return std::clamp(sum / total, track.lowest, track.highest);
    return between_gestures(track, begun, time_ms);
  }

  /// Where no gesture is under way: the last one's target before, the next one's after, and a
  /// straight line from one to the other.
  static double between_gestures(const Track& track, std::size_t begun, double time_ms) {
    const auto& gestures = track.gestures;
    if (begun == 0) return gestures.front().target;
    const auto ended = std::ranges::max_element(
        gestures.begin(), gestures.begin() + static_cast<std::ptrdiff_t>(begun), {}, &Gesture::end);
    if (begun == gestures.size()) return ended->target;
    const auto& next = gestures[begun];
    return std::lerp(
        ended->target, next.target, (time_ms - ended->end) / (next.begin - ended->end));
  }

  std::vector<Track> tracks_;
};

}  // namespace

std::unique_ptr<const Movement> time_locked(std::span<const Claimant> claimants,
                                            const ControlClaims& claims) {
  return std::make_unique<TimeLocked>(claimants, claims);
}

}  // namespace bimodal::synth
