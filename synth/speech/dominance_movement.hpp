#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "synth/speech/dominance_sums.hpp"
#include "synth/speech/movement.hpp"

namespace bimodal::synth {

/// The dominance model of Cohen & Massaro (1993): every control is the mean of its targets,
/// weighted by dominance (see blend, which defines it).
///
/// Plain exponentials are summed up in advance (DominanceSums). Where they are not plain, or so far
/// away that the sums underflow, the claims of a window are weighed one by one: a claim whose
/// dominance is below e^-kCut of the greatest one at that instant is left out. Each of these weighs
/// less than e^-kCut of all, so that with N claims a value differs from blend by less than N
/// e^-kCut of the range of its targets: 4e-14 of it for 10,000 segments. So an instant costs as
/// much as there are claims within about kCut / theta of it, however long the utterance.
class DominanceMovement final : public Movement {
 public:
  static constexpr double kCut = 40;

  /// Controls that one channel computes together.
  static constexpr std::size_t kMostTracks = 16;

  explicit DominanceMovement(const ControlClaims& claims);

  void at(Milliseconds time, std::span<double> values) const override;

 private:
  /// The claims of a channel at one peak.
  struct Peak {
    double time_ms = 0;
    double log_alpha = 0;
    Dominance dominance;

    bool operator==(const Peak&) const = default;

    [[nodiscard]] double log_weight(double at_ms) const;
  };

  /// For all peaks from one of them outwards, an upper bound of their dominance by distance.
  struct Bound {
    double log_alpha;  ///< the greatest
    double theta;      ///< the least; 0 where an exponent is not 1
  };

  struct Track {
    std::size_t control;  ///< whose place in `values` it sets
    double lowest;        ///< of its targets
    double highest;
  };

  /// Controls that move with the same dynamics, whose weights are computed once for all of them.
  struct Channel {
    std::vector<Peak> peaks;     ///< by time
    std::vector<Bound> earlier;  ///< of this peak and all before it, seen from behind
    std::vector<Bound> later;    ///< of this peak and all after it, seen from before
    std::vector<Track> tracks;
    std::vector<std::vector<double>> targets;  ///< of each track, one per peak
    std::optional<DominanceSums> sums;
    bool is_damped = false;  ///< whether a peak is critically damped
  };

  /// The peaks that count at an instant, and the greatest log-weight among them.
  struct Window {
    std::size_t first;
    std::size_t last;  ///< one behind
    double largest;
  };

  static void add_bounds(Channel& channel);
  static void add_sums(Channel& channel);
  static double weigh(const Channel& channel, double time_ms, std::span<double> sums);
  static Window window(const Channel& channel, double time_ms);

  std::vector<Channel> channels_;
  std::vector<Track> constant_;  ///< of which all segments ask the same
};

}  // namespace bimodal::synth
