#pragma once

#include <optional>
#include <span>

namespace bimodal::synth {

/// How well one course of values foretells another.
struct Agreement {
  std::size_t instants = 0;
  std::optional<double> r;    ///< Pearson's; absent where one of them does not vary
  double squares = 0;         ///< sum of (predicted - measured)^2
  double squares_scaled = 0;  ///< the same after the best offset and gain: the talker's own
  double offset = 0;          ///< measured is about offset + gain * predicted, least squares
  double gain = 0;            ///< 0 where the prediction does not vary

  /// Root mean square of what is left; of several agreements, of all their instants.
  [[nodiscard]] double rmse() const;
  [[nodiscard]] double rmse_scaled() const;
};

/// Precondition: both are of one length, not empty.
[[nodiscard]] Agreement agreement(std::span<const double> predicted,
                                  std::span<const double> measured);

/// Of several clips: r is the mean of those that there are, squares are summed; offset and gain are
/// means.
[[nodiscard]] Agreement over_clips(std::span<const Agreement> clips);

}  // namespace bimodal::synth
