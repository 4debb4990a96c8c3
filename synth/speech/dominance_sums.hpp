#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "synth/speech/dominance.hpp"

namespace bimodal::synth {

/// Equation 6 for controls that move with the same dynamics, at a cost that does not grow with the
/// number of segments.
///
/// The plain negative exponential (c = 1) of a distance is a product: what a segment weighs at an
/// instant is what it weighs at the next peak on the way there, times the fall from that peak. So
/// for each rate theta the segments on one side of an instant can be summed up once, at every peak;
/// an instant then takes one exponential for each rate and side. This is exact up to rounding.
class DominanceSums {
 public:
  /// More rates than this on one side are not worth summing.
  static constexpr std::size_t kMostRates = 6;

  /// `claims` in order of their peaks, with the dynamics of all controls; `targets` one row per
  /// control, each as long as `claims`. Absent if a dominance is not a plain exponential, or there
  /// are too many rates.
  [[nodiscard]] static std::optional<DominanceSums> of(
      std::span<const Claim> claims, std::span<const std::vector<double>> targets);

  /// The sum of all weights, and in `sums` (one place per control) that of the weighted targets.
  [[nodiscard]] double at(double time_ms, std::span<double> sums) const;

 private:
  /// The segments on one side of an instant.
  struct Side {
    std::vector<double> rates;
    /// At each peak, for each rate: the sum of the weights, then of the weighted targets.
    std::vector<double> sums;
  };

  void add_up(Side& side,
              std::span<const Claim> claims,
              std::span<const std::vector<double>> targets,
              bool is_earlier);
  double add(const Side& side, std::size_t peak, double distance_ms, std::span<double> sums) const;

  std::vector<double> peaks_;
  Side earlier_;            ///< this peak and those before it, at this peak
  Side later_;              ///< this peak and those after it, at this peak
  std::size_t stride_ = 0;  ///< places for one rate at one peak
};

}  // namespace bimodal::synth
